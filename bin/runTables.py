"""Reads the tables that runs leave under postProcessing of a case.

To be imported first: it finds a Python that has numpy and matplotlib, and sets
how all plots look.

Each run has tables of its own, postProcessing/<cloud>/<start>/<name>.dat, or
<name>_2.dat and so on where there was one from the same start before. Their
order is that of the number `Run` in the header, or else of start and number:
never that of the times of files, which a copy changes. What a later run did
again counts.

A last row that is cut off, since the run was killed, the disk was full or the
run goes on, is left out with a note. Whatever else is wrong ends the program
with one line that names the file.
"""

import io
import os
import re
import sys
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


class Table:
    """The header, and the rows as words with the numbers of their lines."""

    def __init__(self, file, start=0.0, number=1):
        self.file, self.start, self.number = Path(file), start, number
        try:
            text = self.file.read_text(errors="replace")
        except OSError as error:
            fail(f"{file}: {error.strerror}")
        whole, _, rest = text.rpartition("\n")
        lines = list(enumerate(whole.split("\n"), 1))
        self.header = [line for _, line in lines if line.startswith("#")]
        self.rows = [(k, line.split()) for k, line in lines
                     if line.strip() and not line.startswith("#")]
        short = (len(self.rows) > 1
                 and len(self.rows[-1][1]) < len(self.rows[0][1]))
        if short:
            self.rows.pop()
        if rest or short:
            note(f"the last row of {file} is cut off, and left out")

        run = [line.split(":")[1] for line in self.header
               if re.match(r"# Run\s*: *\d+\s*$", line)]
        self.run = int(run[0]) if run else None

    def names(self):
        """Of the columns, without units; of our own tables."""
        if not self.header:
            fail(f"{self.file} has no header")
        return [re.sub(r"\[.*", "", name)
                for name in self.header[-1][1:].split()]

    def numbers(self, columns=None):
        """An array with a row for each row; of some columns if given."""
        if not self.rows:
            return np.empty((0, 0))
        n = len(self.rows[0][1])
        data = []
        for k, words in self.rows:
            try:
                if len(words) != n:
                    raise ValueError(f"{len(words)} columns in place of {n}")
                data.append([float(words[c]) for c in columns or range(n)])
            except (ValueError, IndexError) as error:
                fail(f"{self.file}, line {k}: {error}")
        return np.array(data)


def clouds(case, name="agglomeration"):
    """The names of those that have tables of that name."""
    return sorted({file.parents[1].name for file
                   in Path(case).glob(f"postProcessing/*/*/{name}*.dat")})


def cloud_of(case, named=None):
    """The name of the cloud: the one that is named, aerosol, or the only one"""
    case = Path(case)
    if not case.is_dir():
        fail(f"there is no folder {case}")
    there = clouds(case)
    if not there:
        fail(f"no agglomeration.dat in {case}/postProcessing: has the case"
             " been run?")
    if named is None:
        named = there[0] if len(there) == 1 else "aerosol"
        if named not in there:
            fail("there are several clouds, name one of them: "
                 + " ".join(there))
    if named not in there:
        fail(f"there are no tables of a cloud {named}; there are those of: "
             + " ".join(there))
    return named


def tables(case, cloud, name):
    """The tables of a name, of all runs, in the order of the runs."""
    found = []
    for file in sorted(Path(case, "postProcessing", cloud).glob(
            f"*/{name}*.dat")):
        suffix = re.fullmatch(rf"{name}(?:_(\d+))?\.dat", file.name)
        if suffix and is_time(file.parent.name):
            found.append(Table(file, float(file.parent.name),
                               int(suffix[1] or 1)))
        else:
            note(f"{file} is no table of a run, and passed over")

    if any(table.run is None for table in found):
        return sorted(found, key=lambda table: (table.start, table.number))
    return sorted(found,
                  key=lambda table: (table.run, table.start, table.number))


def required(case, cloud, name, hint="has the case been run?"):
    """The same; there must be some."""
    found = tables(case, cloud, name)
    if not found:
        fail(f"no {name}.dat in {Path(case, 'postProcessing', cloud)}: {hint}")
    return found


def tolerance(times):
    """Of comparisons of times: far less than is between two rows."""
    steps = np.diff(times)
    steps = steps[steps > 0]
    scale = 1e-9*np.abs(times).max(initial=0)
    return min([scale, *1e-3*steps])


def joined(found):
    """The rows of tables that have one at their start, and the tables that
    they come from: what a later run did again counts."""
    data, sources = np.empty((0, 0)), []
    for table in found:
        new = table.numbers()
        if not new.size:
            continue
        start = new[0, 0] - tolerance(new[:, 0])
        sources = [source for source in sources if source[1] < start]
        if data.size:
            data = data[data[:, 0] < start]
        if data.size and data.shape[1] != new.shape[1]:
            fail(f"{table.file} has {new.shape[1]} columns, but"
                 f" {sources[-1][0].file} has {data.shape[1]}")
        data = np.vstack([data, new]) if data.size else new
        sources.append((table, new[0, 0]))
    if not data.size:
        fail(f"{found[-1].file} has no rows yet")
    return data, [table for table, _ in sources]


def series(folder, name):
    """The rows of <folder>/<start>/<name> of all runs, such as of probes."""
    files = of_times(Path(folder).glob(f"*/{name}"), lambda file: file.parent)
    if not files:
        fail(f"no {name} in {folder}: has the case been run?")
    return joined([Table(file, float(file.parent.name)) for file in files])[0]


def last_time(case, name):
    """The folder of the last time that has a file of that name."""
    folders = of_times(file.parent for file in Path(case).glob(f"*/{name}"))
    if not folders:
        fail(f"no time in {case} has a file {name}: has the case been run?")
    return folders[-1]


def bin_edges(table):
    """The edges of the bins [m], from the header of sizeDistribution.dat."""
    for line in table.header:
        if line.startswith("# edges"):
            try:
                return np.array([float(word) for word in line.split()[2:]])
            except ValueError as error:
                fail(f"{table.file}, line '# edges': {error}")
    fail(f"{table.file} has no line '# edges'")


def sizes(case, cloud):
    """Times, numbers by bin, and the edges of the bins, of all runs."""
    data, sources = joined(required(case, cloud, "sizeDistribution"))
    edges = bin_edges(sources[-1])
    for table in sources:
        other = bin_edges(table)
        if len(other) != len(edges) or not np.allclose(other, edges):
            fail(f"{table.file} has other bins than {sources[-1].file}")
    if data.shape[1] != len(edges) + 2:
        fail(f"{sources[-1].file} has {data.shape[1]} columns, but edges of"
             f" {len(edges) - 1} bins")
    return data[:, 0], data[:, 1:], edges
