"""Solve until the sound is periodic, then replay: nobody may notice.

A tube that radiates at one end is periodic soon. The aerosol is a few particles
that do not feel one another.
"""

import re
import shutil
import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.append(str(Path(__file__).resolve().parents[1]))
from aerosolcase import AerosolCase  # noqa: E402
from foamcase import ROOT  # noqa: E402

FREQUENCY = 1400
TUBE = ROOT/"tutorials"/"standingWaveTube"
AEROSOL = ROOT/"tutorials"/"isolatedParticle"/"constant"/"aerosolProperties"

SOLVE = "type compressible; frequency 1400; velocityAmplitude 0.02;"
UNTIL = f"type untilPeriodic; solve {{ {SOLVE} }} tolerance 2e-4;"

LEVEL = """functions
{
    level
    {
        type            soundPressureLevel;
        libs            (acousticDEMFunctionObjects);
        writeControl    writeTime;
        frequency       1400;
        harmonics       2;
        coefficients    yes;
    }
"""

REPLAYED = (
    r"replay differs from what was solved by ([-+.\de]+) % rms, and"
    r" ([-+.\de]+) % at most, of the velocity amplitude of ([-+.\de]+) m/s"
)


def sound(case, text):
    case.replace(
        "constant/acousticProperties", r"(?s)sound\s*\{.*\}",
        f"sound {{ {text} }}",
    )


def tube(directory, periods, text, functions=None):
    case = AerosolCase(directory, TUBE)
    shutil.copy(AEROSOL, case.path/"constant")
    sound(case, text)
    case.replace("system/controlDict", "10.0/", f"{periods}.0/")
    case.replace(
        "system/controlDict", "stepsPerPeriod +200", "stepsPerPeriod 100"
    )
    case.replace("system/controlDict", "ascii", "binary")
    case.replace(
        "system/controlDict", r"writeInterval +\$stepsPerPeriod",
        "writeInterval 250",
    )
    if functions:
        case.replace("system/controlDict", r"functions\s*\{", functions)
    for field, patch, condition in (
        ("U", "left",
         f"type acousticPiston; velocityAmplitude 0.02;"
         f" frequency {FREQUENCY}; rampPeriods 3; value uniform (0 0 0);"),
        ("p", "left", "type fixedFluxExtrapolatedPressure;"),
        ("U", "right", "type waveTransmissive; psi thermo:psi; gamma 1.4;"
         " value uniform (0 0 0);"),
        ("p", "right", "type waveTransmissive; psi thermo:psi; gamma 1.4;"
         " fieldInf 101325; lInf 10; value uniform 101325;"),
    ):
        case.replace(
            f"0/{field}", rf"{patch}\s*\{{[^}}]*\}}",
            f"{patch} {{ {condition} }}",
        )
    case.run("blockMesh")
    return case


@pytest.fixture(scope="module", name="solved")
def fixture_solved(tmp_path_factory):
    case = tube(tmp_path_factory.mktemp("solved")/"case", 20, SOLVE, LEVEL)
    case.run("acousticDEMFoam")
    return case


@pytest.fixture(scope="module", name="replayed")
def fixture_replayed(tmp_path_factory):
    case = tube(tmp_path_factory.mktemp("replayed")/"case", 20, UNTIL, LEVEL)
    case.run("acousticDEMFoam")
    return case


def in_cells(file):
    """The velocities in the cells, of a binary file."""
    content = file.read_bytes()
    start = re.search(
        rb"internalField\s+nonuniform List<vector>\s+(\d+)\s*\(", content
    )
    n = int(start[1])
    return np.frombuffer(content, float, 3*n, start.end()).reshape(n, 3)


def last(case):
    return case.cloud(case.times()[-1])


def test_particles_do_not_notice(solved, replayed):
    log = (replayed.path/"log.acousticDEMFoam").read_text()
    rms, most, amplitude = (
        float(x) for x in re.search(REPLAYED, log).groups()
    )
    print(f"replay: {rms} % rms, {most} % at most, of {amplitude} m/s")
    assert rms <= most < 0.1
    assert amplitude == pytest.approx(0.02, rel=0.1)

    a, b = last(solved), last(replayed)
    velocity = abs(a["U"] - b["U"]).max()/amplitude
    swing = amplitude/(2*np.pi*FREQUENCY)
    position = abs(a["position"] - b["position"]).max()/swing
    print(
        f"velocity of the particles {100*velocity:.3f} %, position"
        f" {100*position:.3f} % of the amplitude off"
    )
    assert velocity < 1e-3
    # A difference in the mean adds up: that of the tolerance, and 14 periods
    assert position < 2*np.pi*14*1e-3


def test_the_solver_has_ended(replayed):
    time = replayed.path/replayed.times()[-1]
    names = {path.name for path in time.iterdir()}
    assert {"U", "UMean", "UCos1", "USin1"} <= names
    assert not {"p", "T", "rho", "phi", "U_0"} & names

    # U is what it should be at the time that is written
    angle = 2*np.pi*FREQUENCY*float(time.name)
    assert in_cells(time/"UCos1").any()
    U = sum(
        factor*in_cells(time/name)
        for name, factor in (
            ("UMean", 1), ("UCos1", np.cos(angle)), ("USin1", np.sin(angle))
        )
    )
    assert in_cells(time/"U") == pytest.approx(U, abs=1e-3*0.02)


def decompose(case, ranks, *options):
    case.write(
        "system/decomposeParDict",
        "FoamFile { version 2.0; format ascii; class dictionary;"
        " object decomposeParDict; }\n"
        f"numberOfSubdomains {ranks}; method simple;"
        f" simpleCoeffs {{ n ({ranks} 1 1); delta 0.001; }}\n",
    )
    case.run("decomposePar", *options)


def solve(case, ranks):
    if ranks == 1:
        return case.run("acousticDEMFoam")
    return case.run(
        "mpirun", "--allow-run-as-root", "--oversubscribe", "-np", ranks,
        "acousticDEMFoam", "-parallel",
    )


@pytest.mark.parametrize("ranks", [1, 2])
def test_restart_replays(tmp_path, replayed, ranks):
    case = tube(tmp_path/"case", 15, UNTIL)
    if ranks > 1:
        decompose(case, ranks)
    solve(case, ranks)
    case.replace("system/controlDict", "15.0/", "20.0/")
    log = solve(case, ranks)
    if ranks > 1:
        case.run("reconstructPar", "-latestTime")

    # The time is written with ten digits; and in parallel the equations are
    # solved to 1e-10 of 1e5 Pa, in another order
    assert "replayed, as at the end of the last run" in log
    a, b = last(case), last(replayed)
    assert a["position"] == pytest.approx(
        b["position"], rel=0, abs=1e-12 if ranks == 1 else 1e-9
    )
    assert a["U"] == pytest.approx(
        b["U"], rel=0, abs=1e-9 if ranks == 1 else 1e-6
    )


def test_solves_again(tmp_path, solved):
    """The solver goes on where it was, and finds the same sound."""
    case = tube(tmp_path/"case", 10, f"{UNTIL} resolveEvery 5;")
    first = case.run("acousticDEMFoam")
    case.replace("system/controlDict", "10.0/", "20.0/")
    log = case.run("acousticDEMFoam")[len(first):]

    # Interrupted in the replay, solved again, replayed again
    assert "From here on" in first and "solved again" not in first
    assert "replayed, as at the end of the last run" in log
    assert "solved again" in log and "From here on" in log
    rms, most, amplitude = (
        float(x) for x in re.search(REPLAYED, log).groups()
    )
    print(f"solved again: {rms} % rms, {most} % at most")
    assert most < 0.1
    again = re.search(r"solved again(.*?)From here", log, re.S).group(1)
    changes = [float(x) for x in re.findall(r"changed by (\S+) %", again)]
    assert changes[0] == 100 and max(changes[1:]) < 0.1

    a, b = last(case), last(solved)
    assert abs(a["U"] - b["U"]).max() < 1e-3*amplitude


def test_solves_again_only_at_steps_that_fit(tmp_path):
    case = tube(tmp_path/"case", 1, f"{UNTIL} resolveEvery 5;")
    case.replace(
        "system/controlDict", "stepsPerPeriod +100", "stepsPerPeriod 100.5"
    )
    log = case.run("acousticDEMFoam", status=1)
    assert "the time step must fit the period" in log


@pytest.mark.parametrize("ranks", [1, 2])
def test_another_case_replays(tmp_path, replayed, ranks):
    """Another mesh, from time 0: small particles show the velocity."""
    case = tube(
        tmp_path/"case", 3,
        f'type replay; source "{replayed.path}";',
    )
    case.replace("system/blockMeshDict", r"\(25 1 1\)", "(4 1 1)")
    case.run("blockMesh")
    case.replace(
        "constant/aerosolProperties", "diameter  1e-6", "diameter 5e-8"
    )
    shutil.rmtree(case.path/"0")

    if ranks > 1:
        decompose(case, ranks)
        decompose(replayed, ranks, "-force", "-latestTime")
    solve(case, ranks)
    if ranks > 1:
        case.run("reconstructPar", "-latestTime")

    (name,) = [t for t in case.times() if float(t) > 2.4/FREQUENCY][-1:]
    cloud = case.cloud(name)
    tracer = np.argmin(cloud["d"])

    source = replayed.path/replayed.times()[-1]
    x = (np.arange(25) + 0.5)*0.1226/25
    angle = 2*np.pi*FREQUENCY*float(name)
    u = sum(
        factor*np.interp(
            cloud["position"][tracer, 0], x, in_cells(source/field)[:, 0]
        )
        for field, factor in (
            ("UMean", 1), ("UCos1", np.cos(angle)), ("USin1", np.sin(angle))
        )
    )
    error = abs(cloud["U"][tracer, 0] - u)/0.02
    print(f"{ranks} ranks: tracer {100*error:.3f} % off")
    # Between cells: 0.5 (k h/2)^2; harmonics below 1e-3; relaxation
    assert error < 5e-3


def test_replays_what_a_function_object_has_left(tmp_path, solved, replayed):
    def tracer(source, more):
        case = tube(
            tmp_path/source.path.parent.name, 1,
            f'type replay; source "{source.path}"; {more}',
        )
        return case.run("acousticDEMFoam"), last(case)

    log, a = tracer(solved, "")
    b = tracer(replayed, "")[1]
    assert "2 harmonics" in log
    assert a["U"] == pytest.approx(b["U"], abs=2e-3*0.02)


@pytest.mark.parametrize(
    "text, what",
    [
        ("type replay; frequency 1400;", "has a field UMean"),
        ('type replay; source "../nowhere";', "has no mesh"),
        ("type replay; sauce 1;", "Unknown entry 'sauce'"),
        ("type untilPeriodic; solve { type standingWave; frequency 1400;"
         " SPL 147; }", "is not solved on the mesh"),
    ],
)
def test_refuses_nonsense(tmp_path, text, what):
    case = tube(tmp_path/"case", 1, text)
    log = re.sub(r"\s+", " ", case.run("acousticDEMFoam", status=1))
    assert what in log


def test_needs_the_frequency(tmp_path, solved):
    """It is kept beside the fields; where that file is lost it must be given."""
    source = tmp_path/"source"
    shutil.copytree(solved.path, source)
    for file in source.glob("*/uniform/harmonics"):
        file.unlink()
    case = tube(tmp_path/"case", 1, f'type replay; source "{source}";')
    log = case.run("acousticDEMFoam", status=1)
    assert "Give the frequency of the sound that is replayed" in log
