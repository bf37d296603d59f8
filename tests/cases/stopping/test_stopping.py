"""A run that is stopped ends cleanly and goes on from where it was."""

import os
import signal
import subprocess
import time

import pytest
from foamcase import FoamCase


def wait(condition, seconds=60):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.05)


@pytest.fixture(name="case")
def fixture_case(tmp_path):
    """An endless case whose sound is solved, with particles."""
    case = FoamCase("flyAshChamber", tmp_path/"case")
    case.replace("constant/aerosolProperties", "2.4e11", "1e10")
    case.replace("constant/acousticProperties", "60.0/", "100000.0/")
    case.replace("system/controlDict", "(?<=endTime) +4;", "  100;")
    case.replace("system/controlDict", "#eval{ round[^;]*;", "1000;")
    case.run("blockMesh")

    # Edits within fileModificationSkew, 10 s, of the last one are not seen
    past = time.time() - 3600
    os.utime(case.path/"system/controlDict", (past, past))
    return case


@pytest.fixture(name="run")
def fixture_run(case):
    """The solver at work in it, after it has written some times."""
    with (case.path/"log").open("w") as log:
        run = subprocess.Popen(
            [f"{os.environ['ACOUSTICDEM_APPBIN']}/acousticDEMFoam"],
            cwd=case.path, stdout=log, stderr=subprocess.STDOUT,
            # A script's background jobs ignore it, and so would the solver
            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
        )
    try:
        wait(lambda: len(times(case)) > 1)
        yield run
    finally:
        run.kill()
        run.wait()


def times(case):
    """Numbers of the steps that are written, except 0."""
    return sorted(
        round(float(path.parent.name)*1400*50)
        for path in case.path.glob("[0-9]*/U") if path.parent.name[-1] != "g"
    )[1:]


def goes_on(case):
    """Three more steps from the last time: the aerosol is complete."""
    last = times(case)[-1]
    case.replace("system/controlDict", r"stopAt [^;]*;", "stopAt endTime;")
    case.replace(
        "system/controlDict", r"endTime  [^;]*;",
        f"endTime #eval{{ {last + 3}.0/(50*$frequency) }};",
    )
    log = case.run("acousticDEMFoam")
    assert log.rstrip().endswith("End")
    first = float(log.split("Create mesh for time = ")[1].split()[0])
    assert round(first*1400*50) == last


def test_stopAt_writeNow(case, run):
    case.replace("system/controlDict", "stopAt [^;]*;", "stopAt writeNow;")
    assert run.wait(60) == 0
    assert (case.path/"log").read_text().rstrip().endswith("End")
    goes_on(case)


@pytest.mark.parametrize("sign", [signal.SIGINT, signal.SIGKILL])
def test_a_signal_leaves_the_last_written_time(case, run, sign):
    # Not while it writes, that time would be incomplete; nor the next one
    time.sleep(0.1)
    run.send_signal(sign)
    assert run.wait(60) == -sign
    assert times(case)[-1] % 200 == 0
    goes_on(case)
