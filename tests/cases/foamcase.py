"""Small helpers of the case tests: copy a case, change it, run it, read it."""

import os
import re
import shutil
import subprocess
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]


class FoamCase:
    """A copy of a tutorial, or of another case, in a scratch directory."""

    def __init__(self, tutorial, directory):
        self.path = Path(directory)
        shutil.copytree(
            ROOT/"tutorials"/tutorial,
            self.path,
            # Not what a run has left there; 0.orig is wanted
            ignore=shutil.ignore_patterns(
                "log.*", "0", "0.[0-9]*", "[1-9]*", "postProcessing",
                "processor*", "*.png",
            ),
        )
        if (self.path/"0.orig").is_dir():
            shutil.copytree(
                self.path/"0.orig", self.path/"0", dirs_exist_ok=True
            )

    def write(self, name, text):
        """Replace a file by another text."""
        (self.path/name).write_text(text)

    def replace(self, name, pattern, text):
        """Replace what must be there in a file, a regular expression."""
        file = self.path/name
        content, n = re.subn(pattern, lambda _: text, file.read_text())
        assert n, f"{pattern} is not in {name}"
        file.write_text(content)

    def run(self, *command, status=0):
        """Run a program in the case and return its log."""
        log = self.path/f"log.{command[0]}"
        with log.open("a") as out:
            result = subprocess.run(
                [
                    "bash", "-c", '. "$0"/bin/environment'
                    ' && exec ${ACOUSTICDEM_PRELOAD:+env'
                    ' LD_PRELOAD="$ACOUSTICDEM_PRELOAD"} "$@"', ROOT,
                ]
                + [str(word) for word in command],
                cwd=self.path,
                env=os.environ,
                stdout=out,
                stderr=subprocess.STDOUT,
                check=False,
            )
        text = log.read_text(errors="replace")
        assert result.returncode == status, text[-3000:]
        return text

    def probes(self, function, field):
        """Times and values (one column per probe) of all runs, in order."""
        runs = sorted(
            (self.path/"postProcessing"/function).iterdir(),
            key=lambda path: float(path.name),
        )
        rows = []
        for run in runs:
            for line in (run/field).read_text().splitlines():
                if not line.startswith("#"):
                    rows.append(
                        [float(x) for x in re.sub("[()]", " ", line).split()]
                    )
        data = np.array(rows)
        return data[:, 0], data[:, 1:]


def harmonics(t, y, frequencies):
    """Complex amplitudes of the frequencies in y, fitted beside a mean."""
    columns = [np.ones_like(t)]
    for f in frequencies:
        columns += [np.cos(2*np.pi*f*t), np.sin(2*np.pi*f*t)]
    fit = np.linalg.lstsq(np.array(columns).T, y, rcond=None)[0]
    return fit[1::2] + 1j*fit[2::2]
