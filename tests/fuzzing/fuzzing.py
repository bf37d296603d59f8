"""Makes, runs and judges cases with one mistake or a few.

A case is one of those of bases.py, with mistakes of mistakes.py. A run passes if
it ends well, with numbers in its tables, or with one fatal error that names a
file of the case. It fails by a signal, by an exception or a stack of addresses,
and if it does not end.
"""

import os
import random
import re
import shutil
import subprocess
from pathlib import Path

from bases import BASES, make_bases
from mistakes import mutate

__all__ = ["BASES", "make_bases", "run", "solve"]

#: Time for a run, and what is said of one that takes longer
SECONDS = 20
LATE = "does not end"

#: Numbers of these decide how long a run is
COSTLY = re.compile(
    r"(kp|kc|resolution|count|numberConcentration|endTime|deltaT|shearRate"
    r"|tolerance|range|length|timeScale|velocity\w*|value|frequenc\w+|T|rho|mu|c"
    r"|SPL|density|diameter|median|max|surfaceTension|writeInterval|interval)\b"
)

NAMES = re.compile(
    r"(acoustic|aerosol|thermophysical|turbulence)Properties|controlDict"
    r"|\b0/[UpT]\b|\.csv|fvSchemes|fvSolution|polyMesh|driveFactor"
)


def judge(case, status, log):
    """What is wrong with a run, empty if nothing is."""
    fatal = len(re.findall(r"FOAM FATAL|FOAM FATAL IO", log))

    if status is None:
        return LATE
    if status not in (0, 1):
        return f"ends with {status}"
    # Where OpenFOAM itself finds a dictionary, it prints the stack (from v2006 on)
    stack = r"terminate called|Traceback|dumped"
    if "stream of primitives from a dictionary" not in log:
        stack += r"|^#\d+ "
    if re.search(stack, log, re.M):
        return "a stack of addresses"
    if status == 1:
        if fatal != 1:
            return f"ends with 1 and {fatal} fatal errors"
        if not NAMES.search(log[log.index("FOAM FATAL"):]):
            return "the error names no file"
        return ""
    if fatal or "\nEnd\n" not in log:
        return "ends with 0, but not well"

    for table in case.glob("postProcessing/*/*.csv"):
        # The last bin of sizes has no upper edge
        none = r"\bnan\b" if table.stem == "sizeDistribution" else r"\b(nan|inf)\b"
        if re.search(none, table.read_text(errors="replace"), re.I):
            return f"numbers that are none in {table.name}"
    for field in case.glob("[0-9]*/*"):
        if field.is_file() and re.search(
            rb"[\s(](-?nan|-?inf)[\s)]", field.read_bytes()
        ):
            return f"numbers that are none in {field.name}"
    return ""


def solve(case):
    """Run a case; returns what is wrong. The log is in the file log."""
    with (case/"log").open("wb") as log:
        try:
            status = subprocess.run(
                ["acousticDEMFoam"], cwd=case, stdin=subprocess.DEVNULL,
                env=dict(os.environ, PWD=str(case)),
                stdout=log, stderr=subprocess.STDOUT, check=False,
                timeout=SECONDS,
            ).returncode
        except subprocess.TimeoutExpired:
            status = None

    text = (case/"log").read_text(errors="replace")
    return judge(case, status, text)


def run(folder, seed, number, keep=None):
    """Make and run one case; returns its base, what was done, what is wrong."""
    chance = random.Random(f"{seed} {number}")
    base = chance.choice(sorted(BASES))
    case = folder/f"case{seed}.{number}"
    shutil.copytree(folder/base, case, ignore=shutil.ignore_patterns("log*"))

    done = mutate(case, base, chance)
    wrong = solve(case)

    # More to compute than there is time for is no fault
    if (
        wrong == LATE
        and "Starting time loop" in (case/"log").read_text(errors="replace")
        and any(COSTLY.search(text) or "controlDict" in text for text in done)
    ):
        wrong = ""
        done.append("(long)")

    if wrong and keep:
        target = Path(keep)/case.name
        shutil.rmtree(target, ignore_errors=True)
        shutil.move(case, target)
    shutil.rmtree(case, ignore_errors=True)

    return base, done, wrong
