"""What the tools have in common: the tables of runs, and how plots look.

To be imported first: it finds a Python that has numpy and matplotlib, and sets
how all plots look.

The tables of our own are postProcessing/<cloud>/<name>.csv, see acousticDEM.
Those of OpenFOAM's function objects are in a folder of the time at which the
run started; what a later run did again counts.

A last row that is cut off, since the run was killed, the disk was full or the
run goes on, is left out with a note. Whatever else is wrong ends the program
with one line that names the file.
"""

import io
import os
import re
import sys
import warnings
from pathlib import Path

try:
    import matplotlib
    import numpy as np
    from PIL import Image  # matplotlib needs it, too
except ImportError as error:
    # bin/environment has looked for a python3 that has them: try it, once
    python = os.environ.pop("ACOUSTICDEM_PYTHON", "")
    if os.path.exists(python):
        os.execv(python, [python, *sys.argv])
    sys.exit(f"ERROR: {error} in {sys.executable}: run bin/setup, or set "
             "ACOUSTICDEM_PYTHON to a python3 with numpy and matplotlib")

import acousticDEM  # with the Python that has been found

matplotlib.use("Agg")

# Okabe and Ito's colours, which the colour-blind tell apart: C0 to C7
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#E69F00", "#56B4E9", "#CC79A7",
           "#808080", "#000000"]

matplotlib.rcParams.update({
    "axes.prop_cycle": matplotlib.cycler(color=COLOURS),
    "axes.grid": True,
    "axes.titlesize": 10,
    "figure.titlesize": 10,
    "font.size": 10,
    "grid.alpha": 0.3,
    "legend.fontsize": 9,
    "legend.frameon": False,
    "savefig.dpi": 130,
})


def fail(message):
    sys.exit(f"ERROR: {message}")


def note(message):
    print(f"NOTE: {message}", file=sys.stderr)


def save(figure, target):
    """Writes a figure as a PNG, of few colours to be small, and says where."""
    picture = io.BytesIO()
    figure.savefig(picture, format="png")
    try:
        Image.open(picture).convert("RGB").quantize(
            256, method=1, dither=0  # rare colours count, too
        ).save(target, format="png", optimize=True)
    except OSError as error:
        fail(f"{target}: {error.strerror}")
    print(f"Wrote {target}")


def is_time(name):
    """Whether the name of a folder is a time; float() takes 0_1 for 1."""
    return re.fullmatch(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?", name)


def of_times(paths, folder=lambda path: path):
    """The paths of which the folder is named by a time, in its order."""
    return sorted((path for path in paths if is_time(folder(path).name)),
                  key=lambda path: float(folder(path).name))


def told(read, *arguments):
    """What a function of acousticDEM returns; its errors end the program."""
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        try:
            result = read(*arguments)
        except acousticDEM.TableError as error:
            fail(error)
    for warning in said:
        note(warning.message)
    return result


def csv(file):
    """The columns of a table by name, as arrays; there must be a row."""
    found = told(acousticDEM.csv, file)
    if not len(next(iter(found.values()))):
        fail(f"{file} has no rows yet")
    return found


def cloud_of(case, named=None):
    """The name of the cloud: the one that is named, aerosol, or the only one"""
    return told(acousticDEM.cloud_of, case, named)


def clouds_of(case, named=None):
    """The cloud that is named, or all that there are."""
    if named is None and acousticDEM.clouds(case):
        return acousticDEM.clouds(case)
    return [cloud_of(case, named)]


def columns(case, cloud, name, names=()):
    """The columns of a table of a cloud by name; it must have some."""
    file = Path(case, "postProcessing", cloud, f"{name}.csv")
    if not file.exists():
        fail(f"no {name}.csv in {file.parent}: has the case been run?")
    found = csv(file)
    for column in names:
        if column not in found:
            fail(f"{file} has no column {column}")
        if found[column].dtype.kind != "f":
            fail(f"{file}: the column {column} is not one of numbers")
    return found


def sizes(case, cloud):
    """Times, number and mass by bin, and the edges of the bins [m], the first
    one 0 and the last one infinite."""
    names = "time_s", "lower_m", "upper_m", "number", "mass_kg"
    found = columns(case, cloud, "sizeDistribution", names)
    n = int((found["time_s"] == found["time_s"][0]).sum())
    rows = len(found["time_s"])//n  # the last time may be cut off
    time, lower, upper, number, mass = (
        found[name][:rows*n].reshape(rows, n) for name in names)
    if not ((time == time[:, :1]).all() and (lower == lower[0]).all()
            and (upper == upper[0]).all()):
        fail(f"{Path(case, 'postProcessing', cloud, 'sizeDistribution.csv')} has"
             " not the same bins at all times")
    return time[:, 0], number, mass, np.append(lower[0], upper[0, -1])


def tolerance(times):
    """Of comparisons of times: far less than is between two rows."""
    steps = np.diff(times)
    steps = steps[steps > 0]
    scale = 1e-9*np.abs(times).max(initial=0)
    return min([scale, *1e-3*steps])


class Table:
    """The rows of a table of OpenFOAM as words, with the numbers of lines."""

    def __init__(self, file):
        self.file = Path(file)
        try:
            text = self.file.read_text(errors="replace")
        except OSError as error:
            fail(f"{file}: {error.strerror}")
        whole, _, rest = text.rpartition("\n")
        self.rows = [(k, line.split())
                     for k, line in enumerate(whole.split("\n"), 1)
                     if line.strip() and not line.startswith("#")]
        short = (len(self.rows) > 1
                 and len(self.rows[-1][1]) < len(self.rows[0][1]))
        if short:
            self.rows.pop()
        if rest or short:
            note(f"the last row of {file} is cut off, and left out")

    def numbers(self):
        """An array with a row for each row."""
        if not self.rows:
            return np.empty((0, 0))
        n = len(self.rows[0][1])
        data = []
        for k, words in self.rows:
            try:
                if len(words) != n:
                    raise ValueError(f"{len(words)} columns in place of {n}")
                data.append([float(word) for word in words])
            except ValueError as error:
                fail(f"{self.file}, line {k}: {error}")
        return np.array(data)


def series(folder, name):
    """The rows of <folder>/<start>/<name> of all runs, such as of probes."""
    files = of_times(Path(folder).glob(f"*/{name}"), lambda file: file.parent)
    if not files:
        fail(f"no {name} in {folder}: has the case been run?")
    data = np.empty((0, 0))
    for file in files:
        new = Table(file).numbers()
        if not new.size:
            continue
        if data.size and data.shape[1] != new.shape[1]:
            fail(f"{file} has {new.shape[1]} columns, but earlier runs have"
                 f" {data.shape[1]}")
        if data.size:
            data = data[data[:, 0] < new[0, 0] - tolerance(new[:, 0])]
        data = np.vstack([data, new]) if data.size else new
    if not data.size:
        fail(f"{files[-1]} has no rows yet")
    return data


def last_time(case, name):
    """The folder of the last time that has a file of that name."""
    folders = of_times(file.parent for file in Path(case).glob(f"*/{name}"))
    if not folders:
        fail(f"no time in {case} has a file {name}: has the case been run?")
    return folders[-1]
