"""A run that is interrupted, or killed, goes on as if nothing had happened."""

import re
import shutil
import signal
import subprocess
import time

import numpy as np
import pytest
from aerosolcase import AerosolCase

# A power of two, of which all multiples are exact in the name of a time: else
# OpenFOAM starts again from a time that is rounded to timePrecision
STEP = 2**-17  # s


def prepare(directory, meshed, writeFormat="binary"):
    """Forty steps, written every ten, with many contacts."""
    case = AerosolCase(directory, meshed)
    case.aerosol("numberConcentration", "30e12")
    case.control("writeFormat", writeFormat)
    if writeFormat == "binary":  # which needs no more
        case.control("writePrecision", "6")
    case.control("writeInterval", "10")
    case.control("deltaT", repr(STEP))
    case.control("timePrecision", "16")
    case.control("endTime", repr(40*STEP))

    # Rows in between too
    case.replace(
        "constant/aerosolProperties", "domain",
        f"report {{ interval {4*STEP!r}; }}\n\ndomain",
    )

    # Thermal velocities, numbers of steps and the way of eddies go on, too
    case.write(
        "constant/aerosolProperties",
        (case.path/"constant"/"aerosolProperties").read_text()
        + "\nBrownian { type OrnsteinUhlenbeck; }\n"
        + "\nturbulence { type syntheticTurbulence; dissipation 1e3; }\n",
    )
    return case


def same_clouds(one, other):
    assert one.times() == other.times()
    for name in one.times():
        a, b = one.cloud(name), other.cloud(name)
        for field, values in a.items():
            assert np.array_equal(values, b[field]), (name, field)


def same_tables(one, other):
    """As if the run had never been interrupted."""
    for name in ("agglomeration", "sizeDistribution"):
        a, b = (
            (case.path/f"postProcessing/aerosol/{name}.csv").read_text()
            for case in (one, other)
        )
        assert a == b and len(a.splitlines()) > 5


@pytest.mark.parametrize("writeFormat, wake, bounces", [
    ("binary", "type Oseen; range 20;", False),
    ("ascii", "type Oseen; range 20;", False),
    ("binary", "type Oseen;", False),
    ("ascii", "type Oseen;", False),
    ("ascii", "type Oseen; range 20;", True),
    ("ascii", "type history; range 8;", False),
])
def test_continues(tmp_path, meshed, writeFormat, wake, bounces):
    def make(name):
        case = prepare(tmp_path/name, meshed, writeFormat)
        case.model("wake", wake)
        if bounces:
            case.replace(
                "constant/aerosolProperties", "type OrnsteinUhlenbeck", "type none"
            )
            case.model(
                "contact", "type probability; sticking 0.3; restitution 0.8;"
            )
        return case

    whole = make("whole")
    whole.run("acousticDEMFoam")

    parts = make("parts")
    parts.control("endTime", repr(20*STEP))
    parts.run("acousticDEMFoam")
    start = float(parts.times()[-1])
    parts.control("endTime", repr(40*STEP))
    log = parts.run("acousticDEMFoam")

    contacts = whole.table()["contacts"]
    half = np.argmin(np.abs(whole.table()["time_s"] - start))
    print(f"contacts {contacts[half]:.0f} and {contacts[-1]:.0f}")
    assert 0 < contacts[half] < contacts[-1]

    assert "Continuing with the" in log

    same_clouds(whole, parts)
    same_tables(whole, parts)


def test_continues_where_most_particles_rest(tmp_path, meshed):
    """A thin aerosol, in which eventDriven looks ahead: over times of writing
    and rows of tables, which come in between."""
    cases = []
    for name in ("whole", "parts"):
        case = AerosolCase(tmp_path/name, meshed)
        case.aerosol("length", "1.6e-3")
        case.aerosol("numberConcentration", "3e11")
        case.model("timeStepping", "type eventDriven;")
        case.model("wake", "type Oseen; range 20;")
        case.control("deltaT", repr(STEP))
        case.control("timePrecision", "16")
        case.control("writeInterval", "73")
        case.control("endTime", repr(292*STEP))
        case.replace(
            "constant/aerosolProperties", "domain",
            f"report {{ interval {7*STEP!r}; }}\n\ndomain",
        )
        cases.append(case)

    whole, parts = cases
    assert "    ahead     " in whole.run("acousticDEMFoam")

    parts.control("endTime", repr(146*STEP))
    parts.run("acousticDEMFoam")
    parts.control("endTime", repr(292*STEP))
    parts.run("acousticDEMFoam")

    same_clouds(whole, parts)
    same_tables(whole, parts)


@pytest.mark.parametrize("precision", ["6", "12"])
def test_continues_with_few_digits_in_the_names_of_times(
    tmp_path, meshed, precision
):
    """A step that no name can hold; the value of the time is kept beside it."""
    step = 1/1400/97
    cases = []
    for name in ("whole", "parts"):
        case = prepare(tmp_path/name, meshed)
        case.control("deltaT", f"{step:.17g}")
        case.control("timePrecision", precision)
        case.control("endTime", f"{20*step:.17g}")
        cases.append(case)

    whole, parts = cases
    whole.run("acousticDEMFoam")
    parts.control("endTime", f"{10*step:.17g}")
    parts.run("acousticDEMFoam")
    name = parts.times()[-1]
    assert float(name) != 10*step
    parts.control("endTime", f"{20*step:.17g}")
    parts.run("acousticDEMFoam")
    same_clouds(whole, parts)

    # A folder that was renamed means what its name says
    other = f"{float(name)*1.25:.{precision}g}"
    for old in parts.times()[2:]:
        shutil.rmtree(parts.path/old)
    (parts.path/name).rename(parts.path/other)
    parts.control("endTime", f"{float(other) + 10*step:.17g}")
    parts.run("acousticDEMFoam")
    assert float(parts.times()[-1]) > float(other) + 9.9*step


def test_continues_from_collated_files(tmp_path, meshed):
    """Serially and on two ranks in turn; what is not whole has a name."""
    whole = prepare(tmp_path/"whole", meshed)
    whole.run("acousticDEMFoam")

    case = prepare(tmp_path/"case", meshed)
    case.control("endTime", repr(10*STEP))
    case.run("acousticDEMFoam", "-fileHandler", "collated")
    case.control("endTime", repr(20*STEP))
    log = case.run("acousticDEMFoam", "-fileHandler", "collated")
    assert "Continuing with the" in log

    case.write(
        "system/decomposeParDict",
        "FoamFile { version 2.0; format ascii; class dictionary;"
        " object decomposeParDict; }\nnumberOfSubdomains 2; method simple;"
        " simpleCoeffs { n (1 2 1); delta 0.001; }\n",
    )
    case.run("decomposePar", "-fileHandler", "collated", "-latestTime")
    parallel = (
        "mpirun", "--oversubscribe", "-np", 2,
        "acousticDEMFoam", "-parallel", "-fileHandler", "collated",
    )
    for steps in (30, 40):
        case.control("endTime", repr(steps*STEP))
        log = case.run(*parallel)
        assert log.count("Continuing with the") == steps//10 - 2
    assert not list(case.path.glob("processor[0-9]"))

    end = case.path/"processors2"/whole.times()[-1]
    mark = end/"uniform"/"incomplete"
    mark.write_text("")
    log = " ".join(case.run(*parallel, status=1).split())
    assert f"remove {end}" in log
    mark.unlink()

    case.run("reconstructPar", "-fileHandler", "collated", "-latestTime")
    expected = whole.cloud(whole.times()[-1])
    for field, values in case.cloud(case.times()[-1]).items():
        assert np.array_equal(values, expected[field]), field


@pytest.fixture(scope="module", name="stopped")
def fixture_stopped(tmp_path_factory, meshed):
    """Interrupted, with all that a state may have."""
    case = prepare(tmp_path_factory.mktemp("stopped")/"case", meshed)
    case.aerosol("numberConcentration", "3e12")
    case.write(
        "constant/aerosolProperties",
        (case.path/"constant"/"aerosolProperties").read_text()
        + "\nunsteadyDrag { type Basset; }\n",
    )
    case.control("endTime", repr(10*STEP))
    case.run("acousticDEMFoam")
    case.control("endTime", repr(12*STEP))
    return case


def lose(file):
    file.unlink()


def cut(file):
    content = file.read_bytes()
    file.write_bytes(content[:len(content)*2//3])


def empty(file):
    file.write_bytes(b"")


def first_number(value):
    def change(file):
        content = file.read_bytes()
        start = re.search(rb"\n\d+\s*\(", content[content.index(b"// *"):])
        at = content.index(b"// *") + start.end()
        file.write_bytes(
            content[:at] + np.float64(value).tobytes() + content[at + 8:]
        )
    change.__name__ = f"first is {value}"
    return change


@pytest.mark.parametrize("name, damage, message", [
    ("history3", lose, "'history3'"),
    ("historyStep", lose, "'historyStep'"),
    ("history0", empty, "'history0'"),
    ("UBrownian", lose, "'UBrownian'"),
    ("U", cut, "lagrangian/aerosol/U"),
    ("id", empty, "'id'"),
    ("d", first_number(0), "must be positive"),
    ("mass", first_number(np.nan), "'mass'"),
    ("position", first_number(np.inf), "no finite number"),
    ("../../uniform/aerosolState", cut, "aerosolState"),
    ("../../uniform/aerosolState", empty, "aerosolState"),
    ("../../uniform/time", empty, "its files are not whole"),
], ids=lambda value: getattr(value, "__name__", str(value)))
def test_refuses_a_state_that_is_not_whole(
    tmp_path, stopped, name, damage, message
):
    case = copied(stopped, tmp_path/"case")
    damage(case.path/case.times()[-1]/"lagrangian"/"aerosol"/name)
    log = " ".join(case.run("acousticDEMFoam", status=1).split())
    assert "FOAM FATAL" in log and message in log
    assert "printStack" not in log


def copied(case, directory):
    copy = AerosolCase.__new__(AerosolCase)
    copy.path = directory
    shutil.copytree(case.path, directory, ignore=shutil.ignore_patterns("log.*"))
    return copy


def test_refuses_a_time_that_is_being_written(tmp_path, stopped):
    case = copied(stopped, tmp_path/"case")
    last = case.path/case.times()[-1]
    (last/"uniform"/"incomplete").write_text("")
    log = " ".join(case.run("acousticDEMFoam", status=1).split())
    assert f"remove {last}" in log

    # Nor from one where there was no time to write even that
    (last/"uniform"/"incomplete").unlink()
    for path in sorted(last.rglob("*"), reverse=True):
        path.unlink() if path.is_file() else path.rmdir()
    log = " ".join(case.run("acousticDEMFoam", status=1).split())
    assert f"remove {last}" in log

    last.rmdir()
    assert "Continuing with" in case.run("acousticDEMFoam")


def test_writes_a_row_per_interval(tmp_path, meshed):
    """Also where it is no whole number of steps; and at times written."""
    case = prepare(tmp_path/"case", meshed)
    case.replace(
        "constant/aerosolProperties", "interval [^;]*;",
        f"interval {3.4*STEP!r};",
    )
    case.run("acousticDEMFoam")
    due = {round(3.4*n) for n in range(12)} | {0, 10, 20, 30, 40}
    rows = np.round(case.table()["time_s"]/STEP).astype(int)
    assert list(rows) == sorted(due)


def test_finds_a_time_whose_name_has_many_digits(tmp_path, meshed):
    """OpenFOAM does not try 16 digits if a name has as many in 17 as in 18."""
    case = prepare(tmp_path/"case", meshed)
    case.control("timePrecision", "10")
    case.run("acousticDEMFoam")
    last = case.times()[-1]
    name = next(
        name for name in (f"{float(last) + k*1.2345e-14:.16g}" for k in range(1, 1000))
        if f"{float(name):.17g}" == f"{float(name):.18g}" != name
    )
    (case.path/last).rename(case.path/name)
    case.control("endTime", repr(60*STEP))
    assert "Continuing with the" in case.run("acousticDEMFoam")

    # With the number of steps, and short names again
    state = (case.path/case.times()[-1]/"uniform"/"time").read_text()
    assert re.search(r"index\s+60;", state)
    for other in case.times():
        digits = re.sub(r"e.*|[.]", "", other).lstrip("0")
        assert len(digits) <= 10 or other == name


def test_names_stay_short_when_the_step_is_edited(tmp_path, meshed):
    """Late times, of which no few digits hold a multiple of the step."""
    case = prepare(tmp_path/"case", meshed)
    case.control("startFrom", "startTime")
    case.control("startTime", "1")
    case.control("timePrecision", "6")
    case.control("writeInterval", "1")

    expected = [1.0]
    steps = [1.0]
    for step in (1/1400/100, 1/1400/97, 1/1400/391):
        expected += [expected[-1] + (n + 1)*step for n in range(4)]
        steps += [step]*4
        case.control("deltaT", f"{step:.17g}")
        case.control("endTime", f"{expected[-1]:.17g}")
        log = case.run("acousticDEMFoam")
        case.control("startFrom", "latestTime")
        assert "to distinguish between timeNames" not in log

        names = case.times()
        print(*names)
        assert len(names) == len(expected)
        for name, exact, length in zip(names, expected, steps):
            assert abs(float(name) - exact) < 0.101*length
            assert len(name) <= 9

            # With all its digits beside it, but for the start
            if name == "1":
                continue
            state = (case.path/name/"uniform"/"time").read_text()
            value = float(re.search(r"value\s+([^;]*);", state)[1])
            assert abs(value - exact) < 1e-14

    # From any of them, also after more digits have been asked for
    case.control("timePrecision", "12")
    before = case.cloud(names[-1])
    for old in names[-3:]:
        shutil.rmtree(case.path/old)
    case.run("acousticDEMFoam")
    times = case.times()
    assert len(times) == len(expected)
    for name, exact in zip(times[-3:], expected[-3:]):
        assert abs(float(name) - exact) < 1e-11
    for field, values in case.cloud(times[-1]).items():
        assert np.array_equal(values, before[field]), field


def test_survives_a_kill(tmp_path, meshed):
    """kill -9 in the middle; what was written is complete, and goes on."""
    case = prepare(tmp_path/"case", meshed)
    case.control("endTime", repr(4000*STEP))
    case.control("writeInterval", "5")

    with (case.path/"log").open("w") as log:
        run = subprocess.Popen(["acousticDEMFoam"], cwd=case.path, stdout=log)
        deadline = time.monotonic() + 60
        while len(case.times()) < 4 and time.monotonic() < deadline:
            time.sleep(0.005)
        run.send_signal(signal.SIGKILL)
        assert run.wait() == -signal.SIGKILL
    assert len(case.times()) >= 4
    assert "End" not in (case.path/"log").read_text()

    # The last time may have been cut off while it was written: without its
    # state, which comes last, the one before is taken
    last = case.path/case.times()[-1]
    written = case.times()[:-1]
    if not (last/"uniform"/"aerosolState").exists():
        for file in sorted(last.rglob("*"), reverse=True):
            file.unlink() if file.is_file() else file.rmdir()
        last.rmdir()

    for name in written:
        cloud = case.cloud(name)
        assert cloud["primaries"].sum() == 3750

    # The same as in a run that was left in peace
    end = float(case.times()[-1]) + 10*STEP
    case.control("endTime", repr(end))
    case.run("acousticDEMFoam")

    whole = prepare(tmp_path/"whole", meshed)
    whole.control("endTime", repr(end))
    whole.control("writeInterval", "5")
    whole.run("acousticDEMFoam")
    same_clouds(whole, case)

    table = case.table()
    assert table["time_s"][-1] == pytest.approx(end)
    assert np.ptp(table["mass_kg"]) < 1e-13*table["mass_kg"][0]


def test_knows_who_has_touched(tmp_path, meshed):
    """Pairs that overlap at a restart, but do not stick, are not new."""
    cases = []
    for name in ("whole", "parts"):
        case = prepare(tmp_path/name, meshed)
        case.model("aggregate", "type none;")
        cases.append(case)

    whole, parts = cases
    whole.run("acousticDEMFoam")
    parts.control("endTime", repr(20*STEP))
    parts.run("acousticDEMFoam")
    parts.control("endTime", repr(40*STEP))
    parts.run("acousticDEMFoam")

    same_clouds(whole, parts)
    assert whole.table()["contacts"][-1] > 10
    assert whole.table()["contacts"][-1] == parts.table()["contacts"][-1]
