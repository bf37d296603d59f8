"""The cloud on disk: other programs find the same particles as the tables."""

import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from aerosolcase import AerosolCase

READER = Path(__file__).resolve().parents[1]/"readCloud.py"


@pytest.fixture(scope="module", name="finished")
def fixture_finished(tmp_path_factory, meshed):
    """The base case after a run in which particles have met."""
    case = AerosolCase(tmp_path_factory.mktemp("cloudFiles")/"case", meshed)
    case.control("writeInterval", "50")
    case.aerosol("numberConcentration", "16e12")
    case.aerosol("centre", "(0.0607 0 0)")
    case.run("acousticDEMFoam")

    # What follows looks at several times, with different numbers
    assert len(case.times()) == 3
    numbers = case.table()["number"]
    assert numbers[0] > numbers[-1]
    return case


@pytest.fixture(name="case")
def fixture_case(tmp_path, finished):
    """A copy of it with its results."""
    shutil.copytree(finished.path, tmp_path/"case")
    case = AerosolCase.__new__(AerosolCase)
    case.path = tmp_path/"case"
    return case


def expected(case, time):
    """Number of particles and largest diameter according to the table."""
    table = case.table()
    row = np.argmin(np.abs(table["time_s"] - float(time)))
    assert table["time_s"][row] == pytest.approx(float(time), abs=1e-12)
    return int(table["number"][row]), table["dMax_m"][row]


def test_fields_agree_with_the_table(finished):
    table = finished.table()

    for time in finished.times():
        cloud = finished.cloud(time)
        number, largest = expected(finished, time)
        row = np.argmin(np.abs(table["time_s"] - float(time)))

        assert len(cloud["d"]) == number
        assert cloud["d"].max() == pytest.approx(largest, rel=1e-9)
        assert np.median(cloud["d"]) == pytest.approx(
            table["CMD_m"][row], rel=1e-3
        )
        assert cloud["mass"].sum() == pytest.approx(
            table["mass_kg"][row], rel=1e-14
        )
        assert cloud["mass"] == pytest.approx(
            2300*np.pi/6*cloud["d"]**3, rel=1e-13
        )
        assert cloud["primaries"].sum() == 2000
        momentum = (cloud["mass"][:, None]*cloud["U"]).sum(axis=0)
        scale = np.abs(cloud["mass"][:, None]*cloud["U"]).sum()
        for k, axis in enumerate("XYZ"):
            assert momentum[k] == pytest.approx(
                table[f"momentum_{axis.lower()}_kg_m_per_s"][row], abs=1e-13*scale
            )


@pytest.mark.skipif(
    not (shutil.which("pvbatch") and shutil.which("xvfb-run")),
    reason="there is no ParaView (pvbatch, xvfb-run)",
)
def test_ParaView(finished):
    """Its own reader, at the first and at every later time."""
    result = subprocess.run(
        ["xvfb-run", "-a", "pvbatch", READER, finished.path],
        capture_output=True, text=True, timeout=120, check=False,
    )
    assert result.returncode == 0, result.stdout + result.stderr

    found = re.findall(r"time (\S+) points (\d+)", result.stdout)
    assert len(found) == len(finished.times())

    for (time, points), name in zip(found, finished.times()):
        number, _ = expected(finished, name)
        assert float(time) == pytest.approx(float(name))
        assert int(points) == number

        cloud = finished.cloud(name)
        for field in ("d", "mass"):
            low, high = re.search(
                rf"time {re.escape(time)} {field}\[0\] min (\S+) max (\S+)",
                result.stdout,
            ).groups()

            # ParaView keeps floats
            assert float(low) == pytest.approx(cloud[field].min(), rel=1e-6)
            assert float(high) == pytest.approx(cloud[field].max(), rel=1e-6)


def test_foamToVTK(case):
    case.run("foamToVTK", "-ascii", "-no-internal", "-no-boundary")

    for name in case.times():
        number, largest = expected(case, name)
        step = case.path/"VTK"/"lagrangian"/"aerosol"
        text = file_of_time(step, name).read_text()
        points = re.search(r"NumberOfPoints='(\d+)'", text)
        d = re.search(r"<DataArray[^>]*Name='d'[^>]*>([^<]*)<", text)
        values = np.array(d[1].split(), float)

        assert int(points[1]) == number
        assert len(values) == number
        assert values.max() == pytest.approx(largest, rel=1e-5)
        assert values.min() == pytest.approx(
            case.cloud(name)["d"].min(), rel=1e-5
        )


def file_of_time(folder, name):
    """The file that the series of foamToVTK names for a time."""
    series = next(folder.glob("*.series")).read_text()
    for file, time in re.findall(
        r'"name"\s*:\s*"([^"]+)",\s*"time"\s*:\s*([^\s}]+)', series
    ):
        if float(time) == pytest.approx(float(name)):
            return folder/file
    raise AssertionError(f"no time {name} in {series}")


@pytest.mark.parametrize("ranks", ["all", "one"])
def test_decompose_and_reconstruct(case, ranks):
    """All particles come back, also where a rank has none of them."""
    # The box lies between x = 0.06045 and 0.06095: of the two halves of the
    # mesh that meet at 0.061 the second has no particles
    numbers = {"all": "(1 2 1)", "one": "(2 1 1)"}[ranks]
    case.write(
        "system/decomposeParDict",
        f"""FoamFile
{{
    version 2.0; format ascii; class dictionary; object decomposeParDict;
}}
numberOfSubdomains 2;
method simple;
coeffs {{ n {numbers}; }}
""",
    )
    case.run("decomposePar", "-time", "0:")
    before = {name: case.cloud(name) for name in case.times()}
    parts = [
        len(list(case.path.glob(f"processor{rank}/*/lagrangian/aerosol/d")))
        for rank in (0, 1)
    ]
    assert parts == ([3, 3] if ranks == "all" else [3, 0])

    for name in before:
        shutil.rmtree(case.path/name)
    case.run("reconstructPar", "-withZero")

    assert case.times() == list(before)
    for name, cloud in before.items():
        after = case.cloud(name)
        for field, values in cloud.items():
            assert np.array_equal(values, after[field]), (name, field)
