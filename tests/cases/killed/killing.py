"""Kill the solver while it writes, and see what the next start makes of it.

A tube whose sound is solved, with particles that have all a restart can lose:
histories, Brownian motion, wakes. It writes three times; it is killed while it
writes the second one.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np

sys.path.append(str(Path(__file__).resolve().parents[1]))
from aerosolcase import AerosolCase  # noqa: E402
from foamcase import ROOT  # noqa: E402

STEP = 1/1400/100  # s
EVERY = 4  # steps
END = 3.1  # times that are written

SOLVED = "type explicitCompressible; frequency 1400; velocityAmplitude 0.2;"
FORMULA = "type standingWave; frequency 1400; SPL 130;"

PISTON = (
    "left { type acousticPiston; velocityAmplitude 0.2; frequency 1400;"
    " rampPeriods 1; value uniform (0 0 0); }"
)


def compiled(directory):
    """The library that kills."""
    library = Path(directory)/"killAt.so"
    subprocess.run(
        ["cc", "-shared", "-fPIC", "-O1", "-o", library,
         Path(__file__).parent/"killAt.c", "-ldl"],
        check=True,
    )
    return library


def prepare(directory, ranks, sound=SOLVED):
    """A case that has not run."""
    case = AerosolCase(directory, ROOT/"tutorials"/"standingWaveTube")
    shutil.copy(
        ROOT/"tutorials/isolatedParticle/constant/aerosolProperties",
        case.path/"constant",
    )
    case.write(
        "constant/aerosolProperties",
        (case.path/"constant"/"aerosolProperties").read_text()
        + "\nBrownian { type OrnsteinUhlenbeck; }\n"
        "unsteadyDrag { type Basset; }\n",
    )
    case.replace(
        "constant/acousticProperties", r"(?s)sound\s*\{.*\}",
        f"sound {{ {sound} }}",
    )
    case.replace("system/controlDict", r"(?s)functions\s*\{.*\n\}", "")
    for key, value in (
        ("deltaT", f"{STEP:.17g}"), ("endTime", f"{END*EVERY*STEP:.17g}"),
        ("writeInterval", str(EVERY)), ("writeFormat", "binary"),
        ("timePrecision", "6"),
    ):
        case.control(key, value)
    case.replace("0/U", r"left\s*\{[^}]*\}", PISTON)
    case.run("blockMesh")
    if ranks > 1:
        case.write(
            "system/decomposeParDict",
            "FoamFile { version 2.0; format ascii; class dictionary;"
            " object decomposeParDict; }\n"
            f"numberOfSubdomains {ranks}; method simple;"
            f" coeffs {{ n ({ranks} 1 1); }}\n",
        )
        case.run("decomposePar")
    return case


def solve(case, ranks, library=None, **kill):
    """The solver; returns its status and text."""
    environment = dict(os.environ)
    command = ["acousticDEMFoam"]
    if library:
        environment.update(kill)
        environment["LD_PRELOAD"] = str(library)
    if ranks > 1:
        command = [
            "mpirun", "--oversubscribe", "-np", str(ranks), *command, "-parallel"
        ]
    run = subprocess.run(
        command, cwd=case.path, env=environment, check=False, text=True,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=300,
        errors="replace",
    )
    return run.returncode, run.stdout


def parts(case, ranks):
    if ranks == 1:
        return [case.path]
    return [case.path/f"processor{i}" for i in range(ranks)]


def times(case, ranks):
    """Names that any rank has, in order."""
    names = {
        folder.name for part in parts(case, ranks) for folder in part.iterdir()
        if re.fullmatch(r"[0-9.e+-]+", folder.name)
    }
    return sorted(names, key=float)


def contents(case, ranks):
    """The fields of the last time, as bytes, by rank and name."""
    last = times(case, ranks)[-1]
    return {
        (part.name if ranks > 1 else "", str(file.relative_to(part))):
            file.read_bytes().split(b"* //", 1)[-1]
        for part in parts(case, ranks)
        for file in sorted((part/last).rglob("*"))
        if file.is_file() and file.name != "time"
    }


def reference(directory, ranks, library, sound=SOLVED):
    """What runs leave that were stopped and continued at the first and at the
    second time (a sound that is solved goes on to the last digit but one); the
    second time; and the number of operations with which each rank writes it."""
    directory = Path(directory)
    whole = []
    for stop in (1, 2):
        case = prepare(directory.parent/f"{directory.name}{stop}", ranks, sound)
        for end in (stop + 0.1/EVERY, END):
            case.control("endTime", f"{end*EVERY*STEP:.17g}")
            status, log = solve(case, ranks)
            assert status == 0, log[-2000:]
        whole.append(contents(case, ranks))
    second = times(case, ranks)[2]

    numbers = []
    for rank in range(ranks):
        counted = prepare(
            directory.parent/f"{directory.name}Counted{rank}", ranks, sound
        )
        kill = {"KILL_IN": f"/{second}", "KILL_COUNT": str(counted.path/"number")}
        if ranks > 1:
            kill["KILL_RANK"] = str(rank)
        status, log = solve(counted, ranks, library, **kill)
        assert status == 0, log[-2000:]
        numbers.append(int((counted.path/"number").read_text().split()[0]))
    return whole, second, numbers


def check(case, ranks, library, whole, **kill):
    """Kill a run and go on. Says how: 'went on', or 'removed' a time first.

    To go on from half a state, or to end without saying what to do, is an
    error."""
    status, log = solve(case, ranks, library, **kill)
    assert status != 0 and "\nEnd\n" not in log, "it was not killed"
    how = "went on"

    status, log = solve(case, ranks)
    if status != 0:
        flat = " ".join(re.sub(r"\[\d+\]", " ", log).split())
        assert "FOAM FATAL" in flat and "remove " in flat, flat[-2000:]
        assert "printStack" not in flat, flat
        names = set(re.findall(r"remove \"?([^\s\"]+)", flat))
        assert len(names) == 1, names
        found = [path for path in case.path.glob(
            str(Path(names.pop()).relative_to(case.path))
        )]
        assert found
        for path in found:
            shutil.rmtree(path)
        how = "removed"
        status, log = solve(case, ranks)
    assert status == 0, log[-2000:]

    now = contents(case, ranks)
    different = [
        [name for name in {**now, **one} if now.get(name) != one.get(name)]
        for one in whole
    ]
    assert [] in different, different
    return how


def unkilled(base, directory):
    """A copy of a case that has been prepared."""
    copy = AerosolCase.__new__(AerosolCase)
    copy.path = Path(directory)
    shutil.copytree(base.path, copy.path)
    return copy


def points(number, count):
    """So many operations, from the first to the last."""
    return sorted({int(x) for x in np.linspace(1, number, count).round()})
