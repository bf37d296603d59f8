"""Pictures and pages of a run: what is drawn, of whatever case."""

import base64
import gzip
import io
import re
import shutil
import sys
from html.parser import HTMLParser
from importlib.machinery import SourceFileLoader
from importlib.util import module_from_spec, spec_from_loader
from pathlib import Path
from xml.etree import ElementTree

import matplotlib.pyplot as plt
import numpy as np
import pytest
from PIL import Image
from test_tools import Results

ROOT = Path(__file__).resolve().parents[3]
sys.path.append(str(ROOT/"bin"))

import acousticDEM  # noqa: E402
import caseFiles  # noqa: E402

HEAD = """FoamFile
{{
    version     2.0;
    format      {};
    class       {};
    object      any;
}}
// *** //

"""


def module(name):
    loader = SourceFileLoader(name, str(ROOT/"bin"/name))
    loaded = module_from_spec(spec_from_loader(name, loader))
    loader.exec_module(loaded)
    return loaded


@pytest.fixture(autouse=True)
def fixture_figures():
    yield
    plt.close("all")


def write_cloud(folder, places, diameters, primaries=None, velocity=(0, 0, 0),
                style="ascii"):
    """The files of a cloud, as far as the tools read them."""
    folder.mkdir(parents=True)
    n = len(diameters)
    primaries = np.ones(n, np.int32) if primaries is None else primaries
    for name, kind, values in (
        ("d", "scalar", np.array(diameters, float)),
        ("position", "vector", np.array(places, float).reshape(n, 3)),
        ("primaries", "label", np.array(primaries, np.int32)),
        ("U", "vector", np.tile(np.array(velocity, float), (n, 1))),
    ):
        head = HEAD.format(style, f"{kind}Field").encode()
        if style == "binary" and n:
            content = head + f"{n}\n(".encode() + values.tobytes() + b")\n"
        elif n and (values == values[0]).all():
            one = " ".join(f"{x:.17g}" for x in np.atleast_1d(values[0]))
            one = f"({one})" if kind == "vector" else one
            content = head + f"{n}{{{one}}}\n\n// *** //\n".encode()
        else:
            rows = [" ".join(f"{x:.17g}" for x in np.atleast_1d(row))
                    for row in values]
            if kind == "vector":
                rows = [f"({row})" for row in rows]
            content = head + (f"{n}(" + " ".join(rows)
                              + ")\n\n// *** //\n").encode()
        (folder/name).write_bytes(content)


class Aerosol:
    """A case with a box of 2 mm about (0.1 0.005 0.005)."""

    def __init__(self, path):
        self.path = path
        for folder in ("constant", "system"):
            (path/folder).mkdir()
        self.properties("domain { type periodicBox; centre (#eval{ 0.2*0.5 }"
                        " 0.005 0.005); length 2e-3; }"
                        " gravity { type uniform; value (0 0 -9.81); }")
        self.sound("type travellingWave; frequency 1400; SPL 147;"
                   " direction (0 1 0);")

    def properties(self, text):
        (self.path/"constant/aerosolProperties").write_text(
            HEAD.format("ascii", "dictionary") + text)

    def sound(self, text):
        (self.path/"constant/acousticProperties").write_text(
            HEAD.format("ascii", "dictionary") + f"sound {{ {text} }}")

    def cloud(self, time, places, *more, name="aerosol", part="", **options):
        write_cloud(self.path/part/time/"lagrangian"/name,
                    0.001*np.array(places, float) + [0.1, 0.005, 0.005],
                    *more, **options)

    def drawn(self, name="aerosol"):
        render = module("renderCloud")
        (cloud,), _ = render.clouds(self.path, name)
        return render, cloud


@pytest.fixture(name="aerosol")
def fixture_aerosol(tmp_path):
    return Aerosol(tmp_path)


def coloured(image):
    """Where an image is neither white nor black nor grey."""
    return np.ptp(image, axis=2) > 0.1


# Particles

def test_aggregates_are_coloured_and_in_front(aerosol):
    """One behind a single particle that hides it, seen from the camera."""
    render = module("renderCloud")
    behind = -0.4*render.DIRECTION/np.linalg.norm(render.DIRECTION)
    aerosol.cloud("0", [behind, -behind, (0.7, 0, 0)], [2e-6, 4e-6, 2e-6])
    aerosol.cloud("0.5", [behind, -behind], [2.5e-6, 4e-6], [2, 1])
    render, cloud = aerosol.drawn()
    before, number, aggregates = cloud.image("0")
    assert (number, aggregates) == (3, 0)
    assert not coloured(before).any()
    after, number, aggregates = cloud.image("0.5")
    assert (number, aggregates) == (2, 1)
    assert before.shape == after.shape
    where = np.argwhere(coloured(after))
    middle = np.array(after.shape[:2])/2
    assert np.abs(where.mean(0) - middle).max() < 2
    radius = 0.5*cloud.enlarged*2.5e-6*cloud.camera.pixels
    assert np.sqrt(len(where)/np.pi) == pytest.approx(radius, rel=0.3)


def test_colours_are_those_of_the_diameters_that_there_are(aerosol):
    """Of aggregates if there are some, of all if not, in a unit that fits."""
    aerosol.cloud("0", [(0, 0, 0), (0.5, 0, 0)], [40e-6, 90e-6])
    _, cloud = aerosol.drawn()
    assert (cloud.colours.vmin, cloud.colours.vmax) == pytest.approx((40, 90))
    assert cloud.unit == "µm"
    assert coloured(cloud.image("0")[0]).any()
    aerosol.cloud("2", [(0, 0, 0), (0.5, 0, 0), (0, 0.5, 0)],
                  [100e-9, 400e-9, 20e-9], [2, 6, 1], name="fine")
    _, cloud = aerosol.drawn("fine")
    assert (cloud.colours.vmin, cloud.colours.vmax) == pytest.approx((100, 400))
    assert cloud.unit == "nm"


def test_the_frame_is_the_box_and_not_the_particles(aerosol):
    aerosol.cloud("0", [(0.1, 0.1, 0.1), (0.2, 0.1, 0.1)], [1e-6, 2e-6])
    _, cloud = aerosol.drawn()
    assert cloud.edge == pytest.approx(2e-3)
    assert cloud.middle == pytest.approx([0.1, 0.005, 0.005])
    corners = cloud.camera.see(np.array([-0.5*cloud.drawn, 0.5*cloud.drawn]))
    assert (corners[:, :2] > 0).all()
    assert (corners[:, :2] < cloud.camera.size).all()

    # A box for which there is no entry is that of the particles
    aerosol.properties("gravity { type none; }")
    _, cloud = aerosol.drawn()
    assert cloud.edge == pytest.approx([1e-4, 0, 0], abs=1e-12)


def test_a_box_as_thin_as_a_line_can_be_seen(aerosol):
    aerosol.properties("domain { type periodicBox; centre (0.1 0.005 0.005);"
                       " length (0.1 1e-4 1e-4); }")
    aerosol.cloud("0", [(-40, 0, 0), (40, 0, 0)], [3e-6, 3e-6])
    render, cloud = aerosol.drawn()
    assert cloud.drawn == pytest.approx([0.1, 0.1/12, 0.1/12])
    assert cloud.enlarged*3e-6 < 0.1/12
    words = [text.get_text() for text in
             render.draw(cloud, ["0"]).findobj(plt.Text)]
    assert any("thinner than it is drawn, along y and z" in w for w in words)
    assert "y: 100 µm" in words and "x: 100 mm" in words


@pytest.mark.parametrize("end, text", [("0.02", "20 ms: 1 particle,"),
                                       ("3", "3 s: 1 particle,")])
def test_titles_say_the_time_in_a_unit_that_fits(aerosol, end, text):
    aerosol.cloud("0", [(0, 0, 0), (0.5, 0, 0)], [1e-6, 1e-6])
    aerosol.cloud(end, [(0, 0, 0)], [1.26e-6], [2])
    render, cloud = aerosol.drawn()
    titles = [axes.get_title() for axes in render.draw(cloud, ["0", end]).axes]
    assert any(title.startswith(text) and "1 of them aggregates" in title
               for title in titles), titles
    assert "diameter of aggregates [µm]" in titles


def test_arrows_of_gravity_and_sound(aerosol):
    """Of a formula its direction; of a sound that is solved that of velocities."""
    aerosol.cloud("0", [(0, 0, 0)]*3, [1e-6]*3, velocity=(0.02, 0, 1.3))
    _, cloud = aerosol.drawn()
    assert cloud.gravity == pytest.approx([0, 0, -9.81])
    assert cloud.sound == pytest.approx([0, 1, 0]) and cloud.travels
    aerosol.sound("type untilPeriodic; solve { type compressible; SPL 147; }")
    _, cloud = aerosol.drawn()
    assert cloud.sound == pytest.approx([0, 0, 1], abs=0.02)
    assert not cloud.travels
    aerosol.sound("type quiescent;")
    _, cloud = aerosol.drawn()
    assert cloud.sound is None


@pytest.mark.parametrize("how", ["ascii", "binary", "packed", "ranks"])
def test_files_of_all_kinds_are_read(aerosol, how):
    places = [(k, 0.1*k, -k) for k in np.linspace(-0.9, 0.9, 7)]
    diameters, primaries = np.linspace(1e-6, 3e-6, 7), [1, 2, 3, 1, 1, 9, 1]
    if how == "ranks":
        for rank, some in enumerate((slice(0, 3), slice(3, 7))):
            aerosol.cloud("0.25", places[some], diameters[some], primaries[some],
                          part=f"processor{rank}", style="binary")
        write_cloud(aerosol.path/"processor2/0.25/lagrangian/aerosol", [], [])
    else:
        aerosol.cloud("0.25", places, diameters, primaries,
                      style="binary" if how == "binary" else "ascii")
    if how == "packed":
        for file in (aerosol.path/"0.25/lagrangian/aerosol").iterdir():
            file.with_name(file.name + ".gz").write_bytes(
                gzip.compress(file.read_bytes()))
            file.unlink()
    found = caseFiles.particles(aerosol.path, "aerosol", "0.25")
    assert found["d"] == pytest.approx(diameters, rel=1e-15)
    assert list(found["primaries"]) == primaries
    assert found["position"] == pytest.approx(
        0.001*np.array(places) + [0.1, 0.005, 0.005], rel=1e-15)
    assert caseFiles.cloud_names(aerosol.path) == ["aerosol"]
    assert caseFiles.times(aerosol.path, "aerosol") == ["0.25"]


def test_a_picture_for_each_cloud_and_a_film(aerosol):
    results = Results(aerosol.path)
    times = ["0", "0.25", "0.5", "1"]
    for name in ("one", "two"):
        for time in times:
            x = 0.9*float(time)
            aerosol.cloud(time, [(x, 0, 0)], [2e-6], name=name)
    tool = ROOT/"bin/renderCloud"
    results.run(tool)
    assert {file.name for file in aerosol.path.glob("*.png")} == {
        "cloud_one.png", "cloud_two.png"}
    results.run(tool, "--cloud", "two", "--film", "gif", "--output", "film.png")
    with Image.open(aerosol.path/"film.gif") as film:
        assert film.n_frames == len(times)
        assert min(film.size) > 300
    if shutil.which("ffmpeg"):
        results.run(tool, ".", "--cloud", "two", "--film")
        assert (aerosol.path/"cloud_two.mp4").read_bytes()[4:8] == b"ftyp"


def test_what_is_wrong_with_a_cloud_is_one_line(aerosol):
    results = Results(aerosol.path)
    tool = ROOT/"bin/renderCloud"
    assert "has the case been run" in results.run(tool, status=1)
    assert "--wrong" in results.run(tool, "--wrong", status=1)
    assert "(choose from 'mp4', 'gif')" in results.run(
        tool, "--film", "webm", status=1)
    assert "nowhere" in results.run(tool, "nowhere", status=1)
    assert "third" in results.run(tool, ".", "third", status=1)
    aerosol.cloud("0", [(0, 0, 0), (0.1, 0, 0)], [1e-6, 2e-6], name="node")
    assert results.run(tool, "--cloud", "anti", status=1).rstrip().endswith(
        "there are: node")
    assert "writeInterval" in results.run(tool, "--film", "gif", status=1)
    file = aerosol.path/"0/lagrangian/node/d"
    for content in (b"", b"\0\0", HEAD.format("ascii", "scalarField").encode(),
                    file.read_bytes().replace(b"2(", b"7("),
                    file.read_bytes().replace(b"e-06", b"many")):
        file.write_bytes(content)
        assert str(file) in results.run(tool, status=1)
    file.unlink()
    shutil.copy(file.with_name("primaries"), file)
    aerosol.properties("domain { centre 1;")
    assert "aerosolProperties" in results.run(tool, status=1)


# Sound

def test_line_of_a_formula_is_exact(box):
    """A wave across: level, and velocity amplitude along the chamber."""
    sound = module("plotSound")
    rms = 20e-6*10**(147/20)
    for kind, level in (
        ("standingWave", lambda s: np.abs(np.cos(s))),
        ("travellingWave", np.ones_like),
    ):
        box.write("constant/acousticProperties", HEAD.format(
            "ascii", "dictionary") + f"""sound
{{ type {kind}; frequency 2000; SPL 147; origin (0.01 0 0); gas {{ c 340; }} }}""")
        chamber = sound.Chamber(box.path)
        levels, speeds = sound.of_formula(chamber)
        s = 2*np.pi*2000/340*(chamber.line()[:, chamber.axes[0]] - 0.01)
        if chamber.axes[0]:
            s = 2*np.pi*2000/340*(chamber.middle[0] - 0.01)*np.ones_like(s)
        assert 20e-6*10**(levels/20) == pytest.approx(
            rms*level(s), rel=1e-4, abs=1e-3)
        assert speeds.max() <= chamber.speed*(1 + 1e-12)
        Results(box.path).run(ROOT/"bin/plotSound")
        assert (box.path/"sound.png").stat().st_size > 5000


def write_levels(case, time, name, function):
    """A field of the mesh that is a function of the centres of the cells."""
    # Of system/blockMeshDict: 4 cells each way, those along x first
    z, y, x = np.meshgrid(*3*[np.arange(4)], indexing="ij")
    centres = 5e-3*np.column_stack([x.ravel(), y.ravel(), z.ravel()]) + [
        53.5e-3, -7.5e-3, -7.5e-3]
    values = " ".join(f"{x:.12g}" for x in function(centres))
    patches = re.findall(r"(?m)^    (\w+)\n    \{", (
        case.path/"constant/polyMesh/boundary").read_text())
    (case.path/time).mkdir(exist_ok=True)
    case.write(f"{time}/{name}", HEAD.format("ascii", "volScalarField") + f"""
dimensions [0 0 0 0 0 0 0];
internalField nonuniform List<scalar> {len(centres)}({values});
boundaryField {{ {" ".join(
    f"{patch} {{ type zeroGradient; }}" for patch in patches)} }}
""")
    return centres


@pytest.mark.parametrize("name, function", [
    ("SPL", lambda x: 130 + 200*x), ("pRms", lambda x: 50 + 3000*x),
    ("pPrime2Mean", lambda x: (50 + 3000*x)**2),
])
def test_levels_on_the_mesh_are_those_of_the_fields(box, name, function):
    sound = module("plotSound")
    sound.POINTS = 2000
    box.write("constant/acousticProperties", HEAD.format("ascii", "dictionary")
              + "sound { type compressible; frequency 1400; SPL 147; }")
    box.write("log.acousticDEMFoam", "    expected level 147 dB: p_rms 448 Pa,"
              " p_amp 633 Pa, u0 1.532 m/s\n")
    chamber = sound.Chamber(box.path)
    axis = chamber.axes[0]
    centres = write_levels(box, "0.5", name, lambda c: function(c[:, axis]))
    fields = sound.last_fields(box.path, sound.LEVELS)
    assert (fields[0].name, fields[1]) == ("0.5", (name,))
    outside = chamber.line()[:1] + 10*chamber.extent
    points = np.vstack([chamber.line(), outside, chamber.grid()[0]])
    values = sound.LEVELS[fields[1]](*sound.sampled(chamber, fields, points))
    # In cells that are not at an end
    inner = np.abs(points[:, axis] - centres[:, axis].mean()) < 5e-3
    exact = function(points[:, axis])
    if name != "SPL":
        exact = sound.decibels(exact if name == "pRms" else np.sqrt(exact))
    assert np.isnan(values[len(chamber.line())])
    assert np.isfinite(np.delete(values, len(chamber.line()))).all()
    assert inner.sum() > 500
    tolerance = 1e-4 if name == "SPL" else 0.5
    assert np.abs(values - exact)[inner].max() < tolerance
    axes = sound.draw(box.path).axes
    assert any(text.get_text() == "SPL of the case, 147 dB"
               for one in axes for text in one.findobj(plt.Text))


def test_levels_of_probes_are_those_of_whole_periods(box):
    """With a start that is louder, and a mean."""
    sound = module("plotSound")
    box.write("constant/acousticProperties", HEAD.format("ascii", "dictionary")
              + "sound { type compressible; frequency 1000; SPL 147; }")
    box.write("log.acousticDEMFoam", "")
    folder = box.path/"postProcessing/microphones/0"
    folder.mkdir(parents=True)
    time = np.arange(0, 15.4e-3, 2e-5)
    wave = np.where(time < 4e-3, 9, 1)*np.sin(2*np.pi*1000*time)
    (folder/"p").write_text(
        "# Probe 0 (0.001 0 0)\n# Probe 1 (0.002 0 0)\n#  Probe 0 1\n# Time\n"
        + "".join(f"{t} {101325 + 20*x} {101325 + 200*x}\n"
                  for t, x in zip(time, wave)))
    (found,) = sound.of_tables(sound.Chamber(box.path))
    label, _, levels = found
    assert label == "microphones"
    assert levels == pytest.approx(
        20*np.log10(np.array([20, 200])/np.sqrt(2)/20e-6), abs=1e-3)


def test_a_case_without_a_level_says_how_to_get_one(box):
    box.write("constant/acousticProperties", HEAD.format("ascii", "dictionary")
              + "sound { type compressible; frequency 1000; SPL 147; }")
    box.write("log.acousticDEMFoam", "")
    tool = ROOT/"bin/plotSound"
    said = Results(box.path).run(tool, status=1)
    assert "soundPressureLevel" in said
    assert "mesh" in Results(box.path).run(tool, str(box.path/"system"), status=1)


# Agglomeration

VOLUME = 2e-9  # m3
EDGES = 0, 1e-6, 1e-5, 2e-5, np.inf
AGGLOMERATION = ("time_s", "number", "concentration_per_m3", "efficiency",
                 "efficiency_PM2_5", "CMD_m", "MMD_m", "GSD", "dMax_m", "contacts",
                 "mass_kg")
SIZES = "time_s", "lower_m", "upper_m", "number", "mass_kg"


def write_csv(file, names, rows):
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(",".join(names) + "\n" + "".join(
        ",".join(f"{x:.17g}" for x in row) + "\n" for row in rows))


def write_tables(case, end, numbers, cloud="aerosol"):
    """Tables of a cloud of 1000 particles, 400 of them above 10 um at first, of
    which in the end there are fewer."""
    folder = case/"postProcessing"/cloud
    times = np.linspace(0, end, len(numbers))
    write_csv(folder/"agglomeration.csv", AGGLOMERATION, [
        (t, N, N/VOLUME, 1 - N/1000, 0.5*(1 - N/1000), 1.25e-6, 2.5e-6, 1.5, 4e-6,
         1000 - N, 3e-9) for t, N in zip(times, numbers)])
    write_csv(folder/"sizeDistribution.csv", SIZES, [
        (times[i], lower, upper, n, m) for i, N in ((0, 1000), (-1, numbers[-1]))
        for lower, upper, n, m in zip(
            EDGES, EDGES[1:], (0, 0.6*N, 0.4*N, 0), (0, 1e-9, 2e-9, 0))])


def lines_of(axes):
    """Coordinates of each line that is no legend."""
    return [line.get_xydata() for line in axes.lines if len(line.get_xydata())]


def test_distributions_of_number_and_mass_per_volume_and_decade(tmp_path):
    plots = module("plotAgglomeration")
    write_tables(tmp_path, 0.02, [1000, 800, 500])
    run = plots.read(tmp_path, "aerosol", "it")
    figure = plots.draw([run], [])
    concentration, efficiency, number, mass = figure.axes
    time, value = lines_of(concentration)[0].T
    assert time == pytest.approx([0, 10, 20])  # ms
    assert value == pytest.approx(np.array([1000, 800, 500])/VOLUME)
    assert "[ms]" in efficiency.get_xlabel()
    steps = [patch.get_data() for patch in number.patches + mass.patches]
    decades = np.array([1, np.log10(2)])
    for step, whole in zip(steps, (1000/VOLUME, 500/VOLUME)):
        assert step.edges == pytest.approx([1, 10, 20])  # um
        assert step.values == pytest.approx(whole*np.array([0.6, 0.4])/decades)
    for step in steps[2:]:  # g/m3
        assert step.values == pytest.approx(
            np.array([1e-6, 2e-6])/VOLUME/decades)
    assert "kg" not in mass.get_ylabel() and "1/m³" in number.get_ylabel()
    scales = [axes.get_yscale() for axes in figure.axes]
    assert scales == ["linear"]*4

    # A tenth and less would be hard to see
    write_tables(tmp_path, 3, [1000, 100, 50])
    figure = plots.draw([plots.read(tmp_path, "aerosol", "it")], [])
    assert [axes.get_yscale() for axes in figure.axes] == [
        "log", "linear", "log", "linear"]
    assert "[s]" in figure.axes[1].get_xlabel()


def test_several_runs_and_what_was_measured(tmp_path):
    results = Results(tmp_path)
    tool = ROOT/"bin/plotAgglomeration"
    for name, N in (("a", 400), ("b", 300)):
        write_tables(tmp_path/name, 2, [1000, N])
    write_csv(tmp_path/"m.csv", ("time_s", "efficiency", "other"),
              [(1, 0.3, 7), (2, 0.65, 7)])
    write_csv(tmp_path/"sizes.csv", ("lower_m", "upper_m", "mass_kg_per_m3"),
              [(1e-6, 1e-5, 0.4)])
    results.run(tool, "a", "b", "--measured", "m.csv", "--measured", "sizes.csv",
                "--output", "both.png")
    assert (tmp_path/"both.png").stat().st_size > 10_000
    assert not (tmp_path/"a/agglomeration.png").exists()

    plots = module("plotAgglomeration")
    runs = [plots.read(tmp_path/name, "aerosol", name) for name in "ab"]
    figure = plots.draw(runs, [
        (name, plots.measured(tmp_path/name)) for name in ("m.csv", "sizes.csv")])
    assert {text.get_text() for text in figure.legends[0].get_texts()} == {
        "a", "b", "m.csv", "sizes.csv"}
    concentration, efficiency, _, mass = figure.axes
    assert [line[-1, 1]*VOLUME for line in lines_of(concentration)[:2]] == \
        pytest.approx([400, 300])
    assert any(np.allclose(line, [(1, 30), (2, 65)])
               for line in lines_of(efficiency) if len(line) == 2)
    assert any(np.allclose(line, [(np.sqrt(10), 400)]) for line in lines_of(mass))

    for content, said in (("", "no rows"), ("a,b\n1,2\n", "lower_m, upper_m"),
                          ("time_s,efficiency\n1\n", "line 2"),
                          ("time_s,mass_kg_per_m3\n1,2\n", "time_s and some of")):
        (tmp_path/"m.csv").write_text(content)
        assert said in results.run(tool, "a", "--measured", "m.csv", status=1)
    assert "nowhere" in results.run(tool, "a", "--measured", "nowhere", status=1)


def test_a_picture_of_each_cloud_or_of_all(tmp_path):
    results = Results(tmp_path)
    tool = ROOT/"bin/plotAgglomeration"
    for cloud in ("node", "antinode"):
        write_tables(tmp_path, 2, [1000, 900], cloud)
    results.run(tool, "--together")
    assert [file.name for file in tmp_path.glob("*.png")] == ["agglomeration.png"]
    results.run(tool)
    assert {file.name for file in tmp_path.glob("*_*.png")} == {
        "agglomeration_node.png", "agglomeration_antinode.png"}


# The page of a run

LOG = """\
Build  : OPENFOAM=1912 patch=200626
Date   : Nov 30 2026
Time   : 21:13:17
nProcs : 3
acousticDEM 0.9.9, revision abc<def>

Sound: standingWave; frequency 1400; SPL 147;
    147 dB: p_rms 447.744 Pa, p_amp 633.206 Pa at the antinode, u0 1.5324 m/s there
    frequency 1400 Hz, wavelength 0.245143 m
Gas: density 1.204 kg/m3, viscosity 1.81e-05 Pa s, sound speed 343.2 m/s


Cloud node
Aerosol: 1000 particles in 2e-09 m3
Models
    drag         SchillerNaumann; slipCorrection Cunningham;
    not given, so by default: unsteadyDrag Brownian
The fastest particle settles at 0.0059 m/s


Cloud antinode
Aerosol: 1000 particles in 2e-09 m3
Models
    drag         Stokes; slipCorrection none;


Starting time loop

--> FOAM Warning :
    From function Foam::here()
    in file here.C at line 7
    The box is <short>
    for its sound
Time = 0.5
    1 of 2 particles left
--> FOAM Warning : From function Foam::here()
    in file here.C at line 7
    The box is <short>
    for its sound
ExecutionTime = 9.38 s  ClockTime = 46 s

node: Steps, on average:
    fluid     1e-05 s, 9967.11 particles

End
"""


class Page(HTMLParser):
    """The elements of a page, which must end in the order in which they began."""

    def __init__(self, content):
        super().__init__()
        self.open, self.tables, self.images, self.text = [], [], [], []
        self.feed(content)
        self.close()
        assert not self.open

    def handle_starttag(self, tag, attrs):
        attrs = dict(attrs)
        assert tag not in ("script", "link", "iframe"), "nothing from elsewhere"
        assert "href" not in attrs
        if tag == "img":
            assert attrs["alt"]
            self.images.append(attrs["src"])
        if tag == "table":
            self.tables.append([])
        if tag == "tr":
            self.tables[-1].append([])
        if tag in ("td", "th"):
            self.tables[-1][-1].append("")
        if tag not in ("img", "meta"):
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        if self.open and self.open[-1] in ("td", "th"):
            self.tables[-1][-1][-1] += data
        elif not self.open or self.open[-1] != "style":
            self.text.append(data)


@pytest.fixture(name="finished")
def fixture_finished(box):
    """A case with the tables, the particles and the log of two clouds."""
    for cloud, N in (("node", 990), ("antinode", 437)):
        write_tables(box.path, 2, [1000, 950, N], cloud)
        for time, n in (("0", 3), ("2", 2)):
            write_cloud(box.path/time/"lagrangian"/cloud,
                        [(0.0613 + 1e-5*k, 0, 0) for k in range(n)], [1e-6]*n)
    write_csv(box.path/"postProcessing/node/quantities.csv",
              ("time_s", "mass_g_per_m3"), [(0, 2.5), (2, 1.234567)])
    aerosol = box.path/"constant/aerosolProperties"
    aerosol.write_text(aerosol.read_text() + "\nclouds { node {} antinode {} }")
    box.write("log.acousticDEMFoam", LOG)
    return box


def page_of(case, *arguments):
    Results(case.path).run(ROOT/"bin/report", *arguments)
    content = (case.path/"report.html").read_text()
    assert not re.search(r"https?:|url\(", content)
    return Page(content), content


def test_numbers_of_the_page_are_those_of_the_tables(finished):
    page, _ = page_of(finished)
    factors = {"number": ("number", 1), "concentration [1/m³]":
               ("concentration_per_m3", 1), "efficiency [%]": ("efficiency", 100),
               "PM2.5 efficiency [%]": ("efficiency_PM2_5", 100),
               "CMD [µm]": ("CMD_m", 1e6), "MMD [µm]": ("MMD_m", 1e6),
               "GSD": ("GSD", 1), "largest [µm]": ("dMax_m", 1e6),
               "contacts": ("contacts", 1)}
    ends, *histories = page.tables[:3]
    tables = {name: acousticDEM.csv(
        finished.path/f"postProcessing/{name}/agglomeration.csv")
        for name in ("antinode", "node")}
    assert [row[0] for row in ends[1:]] == list(tables)
    for name, row, history in zip(tables, ends[1:], histories):
        assert set(ends[0][1:]) == set(history[0][1:]) == set(factors)
        assert [cells[0] for cells in history[1:]] == ["0 s", "1 s", "2 s"]
        for heading, *cells in zip(*history, row):
            if heading == "time":
                continue
            column, factor = factors[heading]
            wanted = factor*tables[name][column][[0, 1, 2, -1]]
            assert [float(cell) for cell in cells] == pytest.approx(
                wanted, rel=2e-3, abs=5e-3), heading
    assert ["mass_g_per_m3", "2.5", "1.23457"] in page.tables[3]
    # At the top: the cloud with the highest efficiency
    assert "56.30 %" in page.text and "efficiency, antinode" in page.text


def test_the_page_says_what_was_computed_and_has_its_pictures(finished):
    page, content = page_of(finished)
    words = " ".join(page.text)
    assert "acousticDEM 0.9.9, revision abc<def>" in words
    for value in ("1400 Hz", "147 dB", "1.532 m/s", "2 s"):  # at the top
        assert value in page.text, value
    assert "OpenFOAM 1912" in words and "Nov 30 2026" in words
    cells = {tuple(row) for table in page.tables for row in table if len(row) == 2}
    assert ("drag", "SchillerNaumann; slipCorrection Cunningham;") in cells
    assert ("drag", "Stokes; slipCorrection none;") in cells
    assert ("not given, by default", "unsteadyDrag Brownian") in cells
    assert ("sound", "standingWave; frequency 1400; SPL 147;") in cells
    assert ("ranks", "3") in cells and ("time of the clock", "46 s") in cells
    assert content.count("The box is &lt;short&gt;") == 1 and "(2 times)" in words
    assert "settles at 0.0059 m/s" in words
    assert "has not come to its end" not in words

    kinds = [image.split(";")[0] for image in page.images]
    assert kinds == ["data:image/svg+xml", "data:image/png", "data:image/png",
                     "data:image/svg+xml"]
    for kind, image in zip(kinds, page.images):
        data = base64.b64decode(image.split("base64,")[1])
        if kind.endswith("png"):
            Image.open(io.BytesIO(data)).verify()
        else:
            drawing = data.decode()
            ElementTree.fromstring(drawing)
            assert "prefers-color-scheme: dark" in drawing
            assert "#000000" not in drawing


def test_the_page_of_a_run_that_failed(finished):
    """It has an error and no particles, and what is left is shown."""
    finished.write("log.acousticDEMFoam", LOG.replace("End", """\
--> FOAM FATAL IO ERROR: (openfoam-1912)
Unknown drag type <mine>

file: aerosolProperties.drag at line 3.
"""))
    shutil.rmtree(finished.path/"0")
    shutil.rmtree(finished.path/"2")
    shutil.rmtree(finished.path/"constant/polyMesh")
    page, _ = page_of(finished)
    words = " ".join(page.text)
    assert "has not come to its end" in words
    assert "Unknown drag type <mine>" in words
    assert "No picture: there is no mesh" in words
    assert len(page.images) == 1

    shutil.rmtree(finished.path/"postProcessing")
    page, _ = page_of(finished)
    assert not page.images and "Unknown drag type" in " ".join(page.text)
    (finished.path/"log.acousticDEMFoam").unlink()
    said = Results(finished.path).run(ROOT/"bin/report", status=1)
    assert "has the case been run" in said
