"""Reads what a case is made of: its dictionaries, clouds and fields.

To be imported after runTables, which finds a Python that has numpy.
"""

import argparse
import gzip
import re
import subprocess
from pathlib import Path

import numpy as np
import runTables

HERE = Path(__file__).resolve().parent


class Arguments(argparse.ArgumentParser):
    """Those of a command; a mistake in them is one line."""

    def __init__(self, text):
        super().__init__(
            usage=re.search(r"Usage: (.*(?:\n {7}.*)*)", text)[1],
            description=text, add_help=False, allow_abbrev=False,
            formatter_class=argparse.RawDescriptionHelpFormatter,
        )
        self.add_argument("-h", "--help", action="store_true")

    def error(self, message):
        runTables.fail(f"{message}; try {self.prog} --help")

    def parse(self):
        given = self.parse_args()
        if given.help:
            print(self.description)
            raise SystemExit
        return given


def folder_of(case):
    """The folder of a case, which must be there."""
    case = Path(case)
    if not case.is_dir():
        runTables.fail(f"there is no folder {case}")
    return case.resolve()


# Dictionaries

def shell(command, *arguments, cwd=None):
    """What a command says, in the environment of OpenFOAM and acousticDEM."""
    done = subprocess.run(
        ["bash", "-c", f'. "$0"/environment && {command}', HERE, *arguments],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
        errors="replace", check=False, cwd=cwd,
    )
    return done.returncode, done.stdout


def parsed(text):
    """The dictionary of a text without directives: words, and lists of them."""
    text = re.sub(r"(?s)//[^\n]*|/\*.*?\*/", "", text)
    words = re.findall(r'"[^"]*"|[{}();]|[^\s{}();"]+', text)
    at = 0

    def values(end):
        nonlocal at
        found = []
        while at < len(words) and words[at] != end:
            at += 1
            found.append(values(")") if words[at - 1] == "(" else words[at - 1])
        at += 1
        return found

    def entries():
        nonlocal at
        found = {}
        while at < len(words) and words[at] != "}":
            name = words[at].strip('"')
            at += 1
            if words[at:at + 1] == ["{"]:
                at += 1
                found[name] = entries()
                at += 1
            else:
                value = values(";")
                found[name] = value[0] if len(value) == 1 else value
        return found

    return entries()


def dictionary(case, name):
    """A dictionary of a case with its variables and sums; empty if there is
    none. OpenFOAM evaluates it."""
    file = Path(case, name)
    if not file.is_file():
        return {}
    status, text = shell('foamDictionary -case "$1" "$2" -expand 2>&1',
                         str(case), str(file))
    if status:
        wrong = re.search(r"(?s)FATAL.*?\n\n(.*?)\n\n", text)
        runTables.fail(f"OpenFOAM cannot read {file}: "
                       + " ".join((wrong[1] if wrong else text).split()))
    return parsed(text[text.find("FoamFile"):])


def merged(general, special):
    """A dictionary with what another one says differently."""
    both = dict(general)
    for name, value in special.items():
        if isinstance(value, dict) and isinstance(both.get(name), dict):
            value = merged(both[name], value)
        both[name] = value
    return both


def clouds(case):
    """The dictionary of each cloud, by its name."""
    properties = dictionary(case, "constant/aerosolProperties")
    special = properties.pop("clouds", None)
    if special is None:
        return {"aerosol": properties} if properties else {}
    return {name: merged(properties, special[name]) for name in special}


def vector(value, default=None):
    """Three numbers; one stands for three. Or else the default."""
    try:
        numbers = np.array(value, float)
    except (ValueError, TypeError):
        return default
    if numbers.size not in (1, 3) or not np.isfinite(numbers).all():
        return default
    return numbers*np.ones(3)


def number(value, default=None):
    try:
        return float(value)
    except (ValueError, TypeError):
        return default


def sound(case):
    """The dictionary of the sound, with what is solved within it."""
    entries = dictionary(case, "constant/acousticProperties").get("sound", {})
    return merged(entries.get("solve", {}), entries)


def box(entries):
    """The lowest and the highest corner of the domain of a cloud [m]"""
    domain = entries.get("domain", {})
    centre, length = vector(domain.get("centre")), vector(domain.get("length"))
    if centre is None or length is None:
        return None
    return centre - 0.5*length, centre + 0.5*length


# Fields

def contents(file):
    """Those of a file, or of a compressed one; None if there is none."""
    try:
        if file.is_file():
            return file.read_bytes()
        packed = file.with_name(file.name + ".gz")
        return gzip.decompress(packed.read_bytes()) if packed.is_file() else None
    except OSError as error:
        return runTables.fail(f"{file}: {error}")


def values(content, start, kind, binary, file):
    """The list that begins there: scalars, labels or vectors."""
    width = 3 if kind == "vector" else 1
    size = re.compile(rb"\s*(\d+)\s*").match(content, start)
    try:
        n, start = int(size[1]), size.end()
        if not n:
            return np.empty((0, 3) if width == 3 else 0)
        uniform = content[start:start + 1] == b"{"
        if binary and not uniform:
            found = np.frombuffer(
                content, np.int32 if kind == "label" else float,
                n*width, start + 1
            )
        else:
            end = re.compile(rb";|//").search(content, start).start()
            found = np.array(
                re.sub(rb"[(){}]", b" ", content[start:end]).split(), float
            )
            if uniform:
                found = np.tile(found, n)
        return found.reshape((n, 3) if width == 3 else n)
    except (TypeError, AttributeError, ValueError) as error:
        return runTables.fail(f"{file} is no list of a cloud: {error}")


def cloud_field(file):
    """A field of a cloud; None if there is no such file."""
    content = contents(file)
    if content is None:
        return None
    kind = re.search(rb"class\s+(\w+)Field", content)
    size = re.search(rb"(?m)^\}[^}]*?^(?=\d)", content)
    if not (kind and size):
        return runTables.fail(f"{file} is no field of a cloud")
    return values(content, size.end(), kind[1].decode(),
                  re.search(rb"format\s+binary", content), file)


def parts(case):
    """The case, or its parts on ranks if it has not been put together."""
    case = Path(case)
    return [case] if cloud_times(case) else sorted(
        case.glob("processor[0-9]*"), key=lambda part: int(part.name[9:])
        if part.name[9:].isdigit() else -1
    )


def cloud_times(folder, cloud="*"):
    """Folders of the times that have a cloud, in their order."""
    return runTables.of_times(
        {file.parents[2] for file in folder.glob(f"*/lagrangian/{cloud}/d*")
         if file.name in ("d", "d.gz")}
    )


def cloud_names(case):
    """Of the clouds that have particles on the disk."""
    return sorted({
        file.parent.name for part in parts(case)
        for file in part.glob("*/lagrangian/*/d*")
        if file.name in ("d", "d.gz") and runTables.is_time(file.parents[2].name)
    })


def times(case, cloud):
    """Names of the times that have that cloud."""
    found = {folder.name for part in parts(case)
             for folder in cloud_times(part, cloud)}
    return sorted(found, key=float)


def particles(case, cloud, time, names=("position", "d", "primaries", "U")):
    """Arrays of a cloud at a time, by name, of all ranks."""
    found = {name: [] for name in names}
    for part in parts(case):
        folder = part/time/"lagrangian"/cloud
        if contents(folder/"d") is None:
            continue
        for name in names:
            field = cloud_field(folder/name)
            if field is None:
                runTables.fail(f"there is no {folder/name}")
            found[name].append(field)
    arrays = {name: np.concatenate(found[name]) for name in names}
    if len({len(array) for array in arrays.values()}) > 1:
        runTables.fail(f"the fields of the cloud {cloud} at {time} in {case}"
                       " are not of the same length")
    return arrays


def time_text(time, end):
    """A time in the unit that fits the end of the run."""
    return f"{time:.4g} s" if end >= 1 else f"{1e3*time:.4g} ms"


def length_unit(length):
    """How many of a unit are in a metre, and the unit: that in which a length is
    between 1 and 1000."""
    for scale, unit in ((1, "m"), (1e3, "mm"), (1e6, "µm")):
        if length*scale > 0.999:
            return scale, unit
    return 1e9, "nm"


# What the solver says

NUMBER = r"([-+.\deE]+)"


def log(case):
    """The log of the last run, or else that of a try which computes nothing."""
    logs = sorted(
        (file for file in Path(case).glob("log.acousticDEMFoam*")
         if file.is_file()), key=lambda file: file.stat().st_mtime
    )
    if logs:
        return logs[-1].read_text(errors="replace"), logs[-1]
    status, text = shell("acousticDEMFoam -dry-run 2>&1", cwd=case)
    if status:
        runTables.fail(f"there is no log.acousticDEMFoam in {case}, and"
                       " acousticDEMFoam -dry-run fails there")
    return text, None


def gas(text):
    """Density [kg/m3], speed of sound [m/s] and so on, from a log."""
    line = re.search(r"(?m)^Gas:(.*)", text)
    return {
        name.strip(): float(value) for name, value in re.findall(
            rf"([a-z ]+) {NUMBER}", line[1] if line else ""
        )
    }


def amplitudes(text):
    """Level [dB], rms pressure [Pa] and velocity amplitude [m/s] of the sound,
    from a log; None for what is not said."""
    found = [re.search(pattern, text) for pattern in (
        rf"{NUMBER} dB: p_rms", rf"p_rms {NUMBER} Pa", rf"u0 {NUMBER} m/s"
    )]
    return [float(match[1]) if match else None for match in found]
