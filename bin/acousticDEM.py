"""The tables that runs leave, for scripts of one's own.

    import acousticDEM

    acousticDEM.clouds("case")                      # ["aerosol"]
    acousticDEM.table("case", "agglomeration")      # a pandas DataFrame
    acousticDEM.join(["seed1", "seed2"])            # one of all cases and clouds

`. bin/environment` puts this module on the path of Python. Without pandas,
columns() has the same tables as arrays of numpy by name.

A last row that is cut off, since the run was killed, the disk was full or the
run goes on, is left out with a warning. Whatever else is wrong with a table is
a TableError that names the file and the line.
"""

import warnings
from pathlib import Path

import numpy as np


class TableError(Exception):
    """A table that is not there, or is none."""


def csv(file):
    """The columns of a table of comma-separated values by name: arrays of
    numbers, or of words where one of the values is no number."""
    try:
        text = Path(file).read_text(encoding="utf-8-sig", errors="replace")
    except OSError as error:
        raise TableError(f"{file}: {error.strerror}") from None
    whole, _, rest = text.rpartition("\n")
    lines = [(k, line) for k, line in enumerate(whole.split("\n"), 1)
             if line.strip()]
    if rest and not lines:
        raise TableError(f"{file} has no whole line")
    if rest:
        warnings.warn(f"the last row of {file} is cut off, and left out",
                      stacklevel=2)
    if not lines:
        raise TableError(f"{file} has no rows")

    names = [name.strip() for name in lines[0][1].split(",")]
    rows = []
    for k, line in lines[1:]:
        row = [word.strip() for word in line.split(",")]
        if len(row) != len(names):
            raise TableError(f"{file}, line {k}: {len(row)} columns in place"
                             f" of {len(names)}")
        rows.append(row)

    return {
        name: _array(column, file, lines)
        for name, column in zip(names, zip(*rows) if rows else [()]*len(names))
    }


def _array(words, file, lines):
    """Numbers, or words where already the first one is no number."""
    try:
        float(words[0] if words else 0)
    except ValueError:
        return np.array(words)
    try:
        return np.array(words, float)
    except ValueError:
        for (k, _), word in zip(lines[1:], words):
            try:
                float(word)
            except ValueError as error:
                raise TableError(f"{file}, line {k}: {error}") from None
        raise


def clouds(case, name="agglomeration"):
    """The names of the clouds of a case that have a table of that name."""
    return sorted(file.parent.name for file
                  in Path(case).glob(f"postProcessing/*/{name}.csv"))


def cloud_of(case, named=None, name="agglomeration"):
    """The name of the cloud: the one that is named, aerosol, or the only one"""
    if not Path(case).is_dir():
        raise TableError(f"there is no folder {case}")
    there = clouds(case, name)
    if not there:
        raise TableError(f"no {name}.csv in {case}/postProcessing: has the case"
                         " been run?")
    if named is None:
        named = there[0] if len(there) == 1 else "aerosol"
        if named not in there:
            raise TableError("there are several clouds, name one of them: "
                             + " ".join(there))
    if named not in there:
        raise TableError(f"there are no tables of a cloud {named}; there are"
                         " those of: " + " ".join(there))
    return named


def columns(case, cloud=None, name="agglomeration"):
    """The columns of a table of a cloud by name, as arrays of numpy."""
    return csv(Path(case, "postProcessing", cloud_of(case, cloud, name),
                    f"{name}.csv"))


def table(case, name="agglomeration", cloud=None):
    """A table of a cloud as a DataFrame; there need be no name of a cloud if
    the case has only one, or one that is called aerosol."""
    import pandas  # only who wants a DataFrame needs it
    return pandas.DataFrame(columns(case, cloud, name))


def join(cases, name="agglomeration", cloud=None):
    """One DataFrame of the tables of all clouds, or one of them, of all cases,
    such as those of several seeds; with the columns case and cloud before the
    others."""
    import pandas
    parts = []
    for case in [cases] if isinstance(cases, (str, Path)) else cases:
        there = clouds(case, name)
        if cloud is not None or not there:
            there = [cloud_of(case, cloud, name)]
        for one in there:
            part = table(case, name, one)
            part.insert(0, "case", str(case))
            part.insert(1, "cloud", one)
            parts.append(part)
    if not parts:
        raise TableError("there are no cases")
    return pandas.concat(parts, ignore_index=True)
