"""The sound does not depend on the number of ranks, and a restart may change it.

A piston, a closed tube: ranks with and without a part of the piston.
"""

import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.append(str(Path(__file__).resolve().parents[1]))
from foamcase import FoamCase  # noqa: E402

PISTON = """left
    {
        type            acousticPiston;
        velocityAmplitude 0.02;
        frequency       1400;
        value           uniform (0 0 0);
    }"""


# Relative to the amplitude: iterations stop at a residual, explicit steps do
# the same sums
MOST = {"compressible": 1e-7, "explicitCompressible": 1e-10}


def prepared(directory, kind):
    case = FoamCase("standingWaveTube", directory)
    case.replace("constant/acousticProperties", "type +compressible",
                 f"type {kind}")
    case.replace("0/U", r"left\s*\{[^}]*\}", PISTON)
    case.replace("system/controlDict", "ascii", "binary")
    case.replace("system/controlDict", "10.0/", "1.0/")
    case.run("blockMesh")
    case.run("setExprFields")
    return case


def pressure(case):
    return case.probes("history", "p")[1]


def decompose(case, ranks):
    case.write(
        "system/decomposeParDict",
        f"""FoamFile
{{
    version 2.0; format ascii; class dictionary; object decomposeParDict;
}}
numberOfSubdomains {ranks};
method  simple;
simpleCoeffs {{ n ({ranks} 1 1); delta 0.001; }}
""",
    )
    case.run("decomposePar", "-force", "-latestTime")


def run_parallel(case, ranks):
    case.run(
        "mpirun", "--oversubscribe", "-np", ranks,
        "acousticDEMFoam", "-parallel",
    )


@pytest.fixture(scope="module", name="kind", params=list(MOST))
def fixture_kind(request):
    return request.param


@pytest.fixture(scope="module", name="serial")
def fixture_serial(tmp_path_factory, kind):
    case = prepared(tmp_path_factory.mktemp("serial")/"case", kind)
    case.run("acousticDEMFoam")
    return pressure(case)


@pytest.mark.parametrize("ranks", [2, 4])
def test_is_that_of_one_rank(tmp_path, kind, serial, ranks):
    case = prepared(tmp_path/"case", kind)
    decompose(case, ranks)
    run_parallel(case, ranks)

    difference = np.abs(pressure(case) - serial).max()
    print(f"{ranks} ranks: {difference} Pa")
    assert difference < MOST[kind]*np.abs(serial - 101325).max()


def test_continues_on_another_number_of_ranks(tmp_path, kind, serial):
    case = prepared(tmp_path/"case", kind)
    case.replace("system/controlDict", r"1\.0/.freq", "0.5/$freq")
    case.replace("system/controlDict", "writeInterval +.stepsPerPeriod",
                 "writeInterval 100")
    case.run("acousticDEMFoam")

    decompose(case, 2)
    case.replace("system/controlDict", r"0\.5/.freq", "1.0/$freq")
    run_parallel(case, 2)

    joined = pressure(case)
    assert joined.shape == serial.shape
    difference = np.abs(joined - serial).max()
    print(f"one rank, then two: {difference} Pa")
    assert difference < 10*MOST[kind]*np.abs(serial - 101325).max()
