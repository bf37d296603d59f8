"""Several pieces of aerosol in one run are what each is in a run of its own."""

import re

import numpy as np
import pytest
from aerosolcase import AerosolCase
from foamcase import ROOT

STEP = 2**-17  # s, exact in the name of a time

CLOUDS = """
clouds
{
    antinode { domain { centre (0.0613 0 0); } }
    aside    { domain { centre (0.0521 0 0); } wake { type none; } }
}
"""

DECOMPOSE = """FoamFile
{{
    version 2.0; format ascii; class dictionary; object decomposeParDict;
}}
numberOfSubdomains {0};
method  simple;
simpleCoeffs {{ n (1 {0} 1); delta 0.001; }}
"""


def prepare(directory, meshed, more="", steps=20):
    case = AerosolCase(directory, meshed)
    case.aerosol("numberConcentration", "30e12")
    case.model("timeStepping", "type eventDriven;")
    case.control("deltaT", repr(STEP))
    case.control("writeInterval", "10")
    case.control("timePrecision", "16")
    case.control("endTime", repr(steps*STEP))
    case.replace(
        "system/controlDict", r"writePrecision\s+16", "writePrecision 17"
    )
    case.write(
        "constant/aerosolProperties",
        (case.path/"constant"/"aerosolProperties").read_text()
        + f"\nreport {{ interval {4*STEP!r}; contacts yes; }}\n" + more,
    )
    return case


def same(one, other, names=("aerosol", "aerosol")):
    time = one.times()[-1]
    assert other.times()[-1] == time
    a, b = one.cloud(time, names[0]), other.cloud(time, names[1])
    for field, values in a.items():
        assert np.array_equal(values, b[field]), field
    for file in ("agglomeration", "sizeDistribution", "contacts"):
        texts = [
            (case.path/"postProcessing"/name/f"{file}.csv").read_text()
            for case, name in zip((one, other), names)
        ]
        assert texts[0] == texts[1], file


def test_are_each_that_of_a_run_of_its_own(tmp_path, meshed):
    both = prepare(tmp_path/"both", meshed, CLOUDS)
    log = both.run("acousticDEMFoam")
    assert "antinode: " in log and "aside: " in log
    assert not (both.path/"postProcessing"/"aerosol").exists()

    for name, centre in (("antinode", 0.0613), ("aside", 0.0521)):
        alone = prepare(tmp_path/name, meshed)
        alone.aerosol("centre", f"({centre} 0 0)")
        if name == "aside":
            alone.model("wake", "type none;")
        alone.run("acousticDEMFoam")
        same(alone, both, ("aerosol", name))
        assert alone.table()["contacts"][-1] > 3


@pytest.mark.parametrize("ranks", [3])
def test_continue_and_do_not_depend_on_the_ranks(tmp_path, meshed, ranks):
    """One box is carried along; half of the run on one rank, half on three."""
    more = CLOUDS.replace("wake", "frame { velocity (0 0.5 1); } wake")

    whole = prepare(tmp_path/"whole", meshed, more)
    whole.run("acousticDEMFoam")

    parts = prepare(tmp_path/"parts", meshed, more)
    parts.control("endTime", repr(10*STEP))
    parts.run("acousticDEMFoam")
    parts.control("endTime", repr(20*STEP))
    parts.write("system/decomposeParDict", DECOMPOSE.format(ranks))
    parts.run("decomposePar", "-force", "-latestTime")
    for folder in parts.path.glob("processor*"):
        for name in parts.times():
            (folder/name).mkdir(exist_ok=True)
    parts.run(
        "mpirun", "--oversubscribe", "-np", ranks,
        "acousticDEMFoam", "-parallel",
    )
    parts.run("reconstructPar", "-latestTime")

    time = whole.times()[-1]
    for name in ("antinode", "aside"):
        a, b = whole.cloud(time, name), parts.cloud(time, name)
        for field, values in a.items():
            assert np.array_equal(values, b[field]), (name, field)
        contacts = whole.table(cloud=name)["contacts"][-1]
        assert contacts > 0
        assert contacts == parts.table(cloud=name)["contacts"][-1]


def test_carried_along_sees_what_it_passes(tmp_path, meshed):
    """Single particles, in a box that a mean flow carries from node to node.

    Exact: m dv/dt = k(u - v) along x, by Runge-Kutta, where u is that at the
    centre of the box and at the swing of the particle from there; across, the
    mean flow.
    """
    flow = np.array([5.0, 0.1, 0])
    start, end, edge = 0.005, 0.1226, 1e-3
    case = AerosolCase(tmp_path/"case", meshed)
    case.replace(
        "constant/acousticProperties", "SPL         147;",
        "SPL 130; velocity (5 0.1 0);",
    )
    case.model("domain", f"type periodicBox; centre ({start} 0 0); length 1e-3;")
    rows = [((start + dx, 2e-4, 1e-4), d)
            for dx, d in ((-4e-4, 2e-6), (0, 8e-6), (4e-4, 20e-6))]
    case.particles(rows)
    case.model("drag", "type Stokes; slipCorrection none;")
    case.model("gravity", "type none;")
    case.model("wake", "type none;")
    case.model("contact", "type none;")
    case.model("timeStepping", "type eventDriven;")
    case.write(
        "constant/aerosolProperties",
        (case.path/"constant"/"aerosolProperties").read_text()
        + "\nframe { velocity (5 0.1 0); }\n",
    )
    # The wall of the mesh at x = end is met on the way
    residence = (end - edge/2 - start)/flow[0]
    case.control("endTime", "0.05")
    case.control("deltaT", "1e-5")
    case.control("writeInterval", "500")

    for coordinate, there in ((51, 0), (71, 122.6)):
        case.replace("system/blockMeshDict", rf"\({coordinate} ", f"({there} ")
    case.run("blockMesh")

    log = case.run("acousticDEMFoam")
    print(log[-800:])
    left = float(re.search(r"leaves the mesh at (\S+) s", log)[1])
    assert left == pytest.approx(residence, rel=1e-5)
    assert "left the mesh at" in log

    table = case.table()
    last = table["time_s"][-1]
    assert last == pytest.approx(np.floor(residence/1e-5)*1e-5)
    final = case.cloud(case.times()[-1])

    rho, c, mu = 1.204, 343.2, 1.81e-5
    omega = 2*np.pi*1400
    u0 = np.sqrt(2)*20e-6*10**(130/20)/(rho*c)

    for i, (x0, d) in enumerate(rows):
        k = 18*mu/(2300*d**2)

        def rate(t, y, k=k):
            centre = omega/c*(start + flow[0]*t)
            swing = -u0/omega*np.sin(centre)*np.real(
                np.exp(1j*omega*t)/(1 + 1j*omega/k)
            )
            u = flow[0] + u0*np.sin(centre + omega/c*swing)*np.sin(omega*t)
            return np.array([y[1], k*(u - y[1])])

        steps = 20000
        h = last/steps
        y = np.array([x0[0], flow[0]])
        for n in range(steps):
            t = n*h
            k1 = rate(t, y)
            k2 = rate(t + h/2, y + h/2*k1)
            k3 = rate(t + h/2, y + h/2*k2)
            k4 = rate(t + h, y + h*k3)
            y = y + h/6*(k1 + 2*k2 + 2*k3 + k4)

        off = final["position"][i] - [y[0], x0[1] + 0.1*last, x0[2]]
        print(f"{1e6*d:g} um: {np.abs(off).max()*omega/u0:.1e} of the swing")
        # Parabolas in time are off by (omega h)^3/72 of the gas' velocity
        assert np.abs(off).max() < 1e-5*u0/omega
        assert np.abs(final["U"][i] - [y[1], 0.1, 0]).max() < 1e-5*u0


@pytest.mark.parametrize("entries, message", [
    ("one 1;", "Entry 'one' is no dictionary"),
    ("", "There are no clouds"),
    ("one { domain { centre (5 0 0); } }", "leaves the mesh"),
    ("one { frame { speed 1; } }", "'speed'"),
    ("one { carriage { velocity (1 0 0); } }", "Unknown dictionary 'carriage'"),
])
def test_refuses(box, entries, message):
    box.write(
        "constant/aerosolProperties",
        (box.path/"constant"/"aerosolProperties").read_text()
        + f"\nclouds\n{{\n{entries}\n}}\n",
    )
    assert message in box.run("acousticDEMFoam", status=1)


SOLVED = """FoamFile
{
    version 2.0; format ascii; class dictionary; object aerosolProperties;
}
domain { type periodicBox; centre (0.0613 5e-3 5e-3); length 1e-3; }
particles
{
    density 2300; source distribution; count 20;
    size { type lognormal; median 4e-6; GSD 1.5; min 1e-6; max 10e-6; }
}
timeStepping { type eventDriven; }
drag { type Stokes; slipCorrection none; }
gravity { type none; }
wake { type none; }
contact { type none; }
aggregate { type none; }
"""

PLACES = {
    "antinode": "",
    "aside": "domain { centre (0.03 5e-3 5e-3); }",
    "moving": "domain { centre (0.02 5e-3 5e-3); } frame { velocity (20 0 0); }",
}


def test_each_has_its_own_region_of_solved_sound(tmp_path):
    """Three boxes in a tube that is solved, one of them on its way."""

    def run(name, more):
        case = AerosolCase(tmp_path/name, ROOT/"tutorials/standingWaveTube")
        case.write("constant/aerosolProperties", SOLVED + more)
        case.replace("system/controlDict", "10.0/", "1.0/")
        case.control("writeFormat", "binary")
        case.run("blockMesh")
        case.run("setExprFields")
        case.run("acousticDEMFoam")
        return case

    def clouds(entries):
        return "clouds\n{\n" + "\n".join(
            f"{name} {{ {text} }}" for name, text in entries.items()
        ) + "\n}\n"

    together = run("together", clouds(PLACES))
    time = together.times()[-1]
    for name, text in PLACES.items():
        alone = run(name, clouds({name: text}))
        a, b = alone.cloud(time, name), together.cloud(time, name)
        for field, values in a.items():
            assert np.array_equal(values, b[field]), (name, field)

    # The gas that each has felt: sin(k x) of the fundamental
    speed = {
        name: np.abs(together.cloud(time, name)["U"][:, 0]).mean()
        for name in ("antinode", "aside")
    }
    ratio = speed["aside"]/speed["antinode"]
    assert ratio == pytest.approx(np.sin(np.pi*0.03/0.1226), rel=0.01)


def test_each_says_how_the_gas_oscillates_there(tmp_path):
    case = AerosolCase(tmp_path/"case", ROOT/"tutorials"/"antinodeAndNode")
    case.run("blockMesh")
    log = case.run("acousticDEMFoam", "-dry-run")
    places = re.findall(r"centre \( (\S+)", log)
    lines = re.findall(
        r"^Relative displacement .* particle (\S+) m \(peak to peak\) where the"
        r" gas oscillates with (\S+) m/s", log, re.M,
    )
    x = np.array(places, float)
    displacement, u0 = np.array(lines, float).T
    assert len(u0) == len(x) == 5

    wave = np.sin(np.pi*x/0.12258)
    print(u0, wave)
    assert u0/u0[0] == pytest.approx(wave/wave[0], abs=1e-3)
    assert displacement/displacement[0] == pytest.approx(u0/u0[0], abs=1e-4)


def test_a_file_without_header_is_not_passed_over(box):
    text = (box.path/"constant/aerosolProperties").read_text()
    box.write("constant/aerosolProperties", text[text.index("domain"):])
    assert "problem while reading header" in box.run(
        "acousticDEMFoam", status=1
    )
