"""How often ranks wait for one another in a fluid step.

This is what ends the scaling on many ranks, and it can be counted: a library
between solver and MPI (countCalls.c) counts the calls in which a rank waits for
others, in two runs of different lengths.
"""

import subprocess
from pathlib import Path

import numpy as np
import pytest
from aerosolcase import AerosolCase

HERE = Path(__file__).resolve().parent
REDUCTIONS, ALL_TO_ALLS, _, OTHERS = range(1, 5)


@pytest.fixture(scope="module", name="library")
def fixture_library(tmp_path_factory):
    file = tmp_path_factory.mktemp("countCalls")/"countCalls.so"
    subprocess.run(
        ["mpicc", "-shared", "-fPIC", "-o", file, HERE/"countCalls.c"],
        check=True,
    )
    return file


def calls(case, ranks, library, monkeypatch):
    """The calls of the rank that has most of them, and the log."""
    counts = case.path/"calls"

    with monkeypatch.context() as patch:
        patch.setenv("OMPI_MCA_mca_base_env_list",
                     f"LD_PRELOAD={library};MPI_CALLS={counts}")
        log = case.run_on(ranks)

    table = np.loadtxt(counts)
    assert len(table) == ranks
    return table[:, :OTHERS + 1].max(axis=0), log


@pytest.mark.parametrize("wake", ["type none;", "type Oseen; range 20;"])
@pytest.mark.parametrize("ranks", [2, 4])
def test_synchronisations_of_a_step(
    tmp_path, meshed, library, monkeypatch, wake, ranks
):
    """In a thin aerosol whose gas is known: six at most, also with the lists."""
    steps = {4: 200, 12: 600}
    counts = []

    for periods in steps:
        case = AerosolCase(tmp_path/f"periods{periods}", meshed)
        case.model("timeStepping", "type eventDriven;")
        case.model("wake", wake)
        case.model("drag", "type Stokes; slipCorrection Cunningham;")
        case.aerosol("length", "(2.4e-3 2.2e-3 2.3e-3)")
        case.aerosol("numberConcentration", "1.6e11")
        case.control("stepsPerPeriod", "50")
        case.control("endTime", f"#eval{{ {periods}.0/$frequency }}")
        case.control("writeInterval", str(steps[periods]))

        count, log = calls(case, ranks, library, monkeypatch)
        counts.append(count)

    perStep = np.diff(counts, axis=0)[0]/np.ptp(list(steps.values()))

    assert "    ahead     " in log
    assert perStep[REDUCTIONS] >= 2
    assert perStep[REDUCTIONS:].sum() <= 6
    # What grows with the number of ranks
    assert perStep[ALL_TO_ALLS] <= 0.3
