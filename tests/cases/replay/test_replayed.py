"""What a replay is told, and what it says: its time, its files, its error.

A tube between a piston and a radiating end, solved explicitly for a few periods.
"""

import re
import shutil

import numpy as np
import pytest
from aerosolcase import csv
from test_replay import decompose, in_cells, sound, tube

SOLVE = "type explicitCompressible; frequency 1400; velocityAmplitude 0.02;"
PERIOD = 1/1400

# Handed over when it is periodic, and too early
PERIODIC = f"type untilPeriodic; solve {{ {SOLVE} }}"
EARLY = f"{PERIODIC} startTime {2*PERIOD};"


def chamber(directory, text, periods=9, functions=None):
    case = tube(directory, periods, text, functions)
    case.replace("system/controlDict", "writeInterval 250", "writeInterval 100")
    case.run("acousticDEMFoam")
    return case


@pytest.fixture(scope="module", name="early")
def fixture_early(tmp_path_factory):
    return chamber(tmp_path_factory.mktemp("early")/"case", EARLY)


@pytest.fixture(scope="module", name="periodic")
def fixture_periodic(tmp_path_factory):
    return chamber(
        tmp_path_factory.mktemp("periodic")/"case",
        f"{PERIODIC} tolerance 5e-3;",
    )


@pytest.fixture(scope="module", name="listener")
def fixture_listener(tmp_path_factory):
    """A case that replays, with its mesh."""
    case = tube(tmp_path_factory.mktemp("listener")/"case", 1, SOLVE)
    case.replace("system/controlDict", "1.0/", "0.05/")
    shutil.rmtree(case.path/"0")
    return case


def copied(case, directory):
    copy = type(case).__new__(type(case))
    copy.path = directory
    shutil.copytree(case.path, directory, ignore=shutil.ignore_patterns("log.*"))
    return copy


def flat(log):
    return " ".join(re.sub(r"\[\d+\]", " ", log).split())


def replay(listener, directory, source, more="", status=0):
    case = copied(listener, directory)
    sound(case, f'type replay; source "{source.path}"; {more}')
    return flat(case.run("acousticDEMFoam", status=status))


def test_replays_the_time_that_is_asked_for(tmp_path, listener, periodic):
    first, *_, last = (
        time for time in periodic.times()
        if (periodic.path/time/"UMean").exists()
    )
    for n, (time, taken) in enumerate(
        [(first, first), (last, last), ("latestTime", last)]
    ):
        log = replay(listener, tmp_path/str(n), periodic, f"time {time};")
        assert f"time {taken}: " in log

    for n, time in enumerate(["0.5", "soon", "(1 2)"]):
        log = replay(
            listener, tmp_path/f"no{n}", periodic, f"time {time};", status=1
        )
        assert "'time'" in log and "printStack" not in log
    assert first in replay(
        listener, tmp_path/"list", periodic, "time 0.5;", status=1
    )


def test_refuses_another_frequency(tmp_path, listener, periodic):
    log = replay(
        listener, tmp_path/"case", periodic, "frequency 1500;", status=1
    )
    assert "1500" in log and "1400 Hz" in log


def test_warns_if_it_is_far_off(tmp_path, listener, early, periodic):
    """The level still rises: what is replayed is not the sound."""
    own = flat((early.path/"log.acousticDEMFoam").read_text())
    other = replay(listener, tmp_path/"early", early)
    for log in (own, other):
        assert "The sound is not periodic: it changed by" in log
        assert re.search(r"miss [\d.]+ % of the sound", log)

    own = flat((periodic.path/"log.acousticDEMFoam").read_text())
    other = replay(listener, tmp_path/"periodic", periodic)
    for log in (own, other):
        assert "not periodic" not in log and "miss" not in log
    assert re.search(r"differs from its mean and harmonics by [\d.e-]+ %", other)


def test_a_restart_warns_again(tmp_path, early):
    case = copied(early, tmp_path/"case")
    case.replace("system/controlDict", "9.0/", "9.1/")
    log = flat(case.run("acousticDEMFoam"))
    assert "replayed, as at the end of the last run" in log
    assert "The sound is not periodic" in log


def scaled(file):
    """Another field of the same form."""
    content = file.read_bytes()
    values = in_cells(file)
    start = content.index(values.tobytes())
    file.write_bytes(
        content[:start] + (1.3*values).tobytes()
        + content[start + values.nbytes:]
    )


def not_finite(file):
    content = file.read_bytes()
    start = content.index(in_cells(file).tobytes())
    file.write_bytes(
        content[:start + 24] + np.float64(np.nan).tobytes()
        + content[start + 32:]
    )


def lost(file):
    file.unlink()


def empty(file):
    file.write_bytes(b"")


def cut(file):
    file.write_bytes(file.read_bytes()[:600])


@pytest.mark.parametrize("restart", [False, True])
@pytest.mark.parametrize("name, damage, message", [
    ("UCos1", scaled, "not the one that was written with it"),
    ("USin1", not_finite, "value (nan"),
    ("USin1", lost, "no field"),
    ("UMean", empty, "UMean"),
    ("USin1", empty, "no field"),
    ("UCos1", cut, "UCos1"),
    ("uniform/replay", cut, "uniform/replay"),
    ("uniform/replay", empty, "uniform/replay"),
])
def test_refuses_what_is_not_whole(
    tmp_path, listener, periodic, restart, name, damage, message
):
    source = copied(periodic, tmp_path/"source")
    for time in source.times():
        if (source.path/time/"UMean").exists():
            damage(source.path/time/name)
    if restart:
        source.replace("system/controlDict", "9.0/", "9.1/")
        log = flat(source.run("acousticDEMFoam", status=1))
    else:
        log = replay(listener, tmp_path/"case", source, status=1)
    assert message in log and "printStack" not in log


@pytest.mark.parametrize("of_source", ["uncollated", "collated"])
@pytest.mark.parametrize("of_case", ["collated", "masterUncollated"])
def test_reads_any_format_of_files(
    tmp_path, listener, periodic, of_source, of_case
):
    source = copied(periodic, tmp_path/"source")
    decompose(source, 2, "-latestTime", "-fileHandler", of_source)
    case = copied(listener, tmp_path/"case")
    sound(case, f'type replay; source "{source.path}";')
    decompose(case, 2, "-fileHandler", of_case)
    case.run(
        "mpirun", "--oversubscribe", "-np", 2, "acousticDEMFoam", "-parallel",
        "-fileHandler", of_case,
    )


def test_refuses_another_number_of_parts(tmp_path, listener, periodic):
    source = copied(periodic, tmp_path/"source")
    decompose(source, 3, "-latestTime")
    case = copied(listener, tmp_path/"case")
    sound(case, f'type replay; source "{source.path}";')
    decompose(case, 2)
    log = flat(case.run(
        "mpirun", "--oversubscribe", "-np", 2, "acousticDEMFoam", "-parallel",
        status=1,
    ))
    assert "has 3 parts" in log and "decompose it into 2" in log


LEVEL = """functions
{
    level
    {
        type            soundPressureLevel;
        libs            (acousticDEMFunctionObjects);
        writeControl    writeTime;
        frequency       1400;
        coefficients    yes;
    }
"""

AVERAGE = """functions
{
    average
    {
        type            fieldAverage;
        libs            (fieldFunctionObjects);
        writeControl    writeTime;
        fields
        (
            U { mean on; prime2Mean off; base time; }
        );
    }
"""


def test_levels_of_what_is_solved_again(tmp_path):
    """The function object goes on when there are fields; no rows of silence."""
    case = chamber(
        tmp_path/"case", f"{EARLY} resolveEvery 2;", 12, LEVEL
    )
    log = (case.path/"log.acousticDEMFoam").read_text()
    assert log.count("From here on") >= 2 and "solved again" in log

    rows = csv(case.path/"postProcessing/level/soundPressureLevel.csv")
    print(rows["period"], rows["SPL_dB"])
    assert len(rows["period"]) > 3 and rows["SPL_dB"].min() > 80
    # The names of the terms are those of the replay while it replays
    last = case.path/case.times()[-1]
    assert (last/"UAmp1").exists() and (last/"UMean").exists()


def test_a_name_has_one_owner(tmp_path):
    case = tube(tmp_path/"case", 3, EARLY, AVERAGE)
    log = flat(case.run("acousticDEMFoam"))
    assert "The field UMean of a function object, as fieldAverage" in log

    case = tube(
        tmp_path/"two", 3, SOLVE, LEVEL + LEVEL.partition("{")[2].replace(
            "level", "second", 1
        ),
    )
    log = flat(case.run("acousticDEMFoam", status=1))
    assert "of another function object" in log


def test_goes_on_with_few_digits_of_text(tmp_path):
    """A frequency that six digits do not hold; fields are binary."""
    f = "1400.816326530612"
    case = tube(
        tmp_path/"case", 3,
        f"type untilPeriodic; startTime 0.0013; solve {{"
        f" type explicitCompressible; frequency {f}; velocityAmplitude 0.02; }}",
    )
    case.replace("system/controlDict", r"writePrecision\s+\d+", "writePrecision 6")
    case.replace("system/controlDict", "writeInterval 250", "writeInterval 300")
    case.run("acousticDEMFoam")
    case.replace("system/controlDict", "3.0/", "3.1/")
    assert "replayed, as at the end" in case.run("acousticDEMFoam")


def test_what_an_earlier_run_has_left_is_not_replayed(tmp_path, early):
    """Solved anew over the times of a run that had replayed."""
    case = copied(early, tmp_path/"case")
    sound(case, f"{PERIODIC} tolerance 1e-9;")
    case.replace("system/controlDict", "latestTime", "startTime")
    case.replace("system/controlDict", "9.0/", "3.0/")
    shutil.rmtree(case.path/"0"/"lagrangian")
    shutil.rmtree(case.path/"0"/"uniform")
    left = case.path/case.times()[3]/"uniform"/"replay"
    assert left.exists()
    case.run("acousticDEMFoam")
    assert not left.exists()
