"""The exact collision kernels of the unit tests, with errors of 3 %."""

import os
import subprocess
from pathlib import Path

import pytest

pytestmark = pytest.mark.full

TESTS = Path(os.environ["ACOUSTICDEM_APPBIN"])/"acousticDEMUnitTests"


@pytest.mark.parametrize("stepping", ["multipleTimeStep", "eventDriven"])
@pytest.mark.parametrize(
    "kernel",
    ["ofLaminarShear", "ofSettling", "ofOrthokineticMotionWithFullRefill"],
)
def test_kernel(kernel, stepping):
    measure(f"*kernels.{kernel}/{stepping}")


@pytest.mark.parametrize("stepping", ["multipleTimeStep", "eventDriven"])
def test_turbulence(stepping):
    measure(f"*turbulentKernel.*/{stepping}")


@pytest.mark.parametrize("edge", [500, 1000, 2000])
def test_turbulence_with_inertia(edge):
    measure(f"*boxOfFlyAsh.*/of{edge}um")


@pytest.mark.parametrize(
    "law",
    [
        "hasSmoluchowskisRateForEqualSpheres",
        "hasSmoluchowskisRateForUnequalSpheres",
        "letsAMonodisperseAerosolDecay",
    ],
)
def test_BrownianCoagulation(law):
    measure(f"BrownianCoagulation.{law}")


def measure(tests):
    if not TESTS.exists():
        pytest.skip("there are no unit tests: run ./Allwmake --tests")
    run = subprocess.run(
        [TESTS, "--full", f"--gtest_filter={tests}"],
        capture_output=True, text=True, check=False,
    )
    print(run.stdout)
    assert run.returncode == 0, run.stderr
    assert "K/theory" in run.stdout
