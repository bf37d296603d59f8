"""The folders of src stand in layers: each includes only headers of lower ones."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]

# From below to above; folders of one line do not know each other
LAYERS = """
    common
    acoustics/harmonics acoustics/sampling acoustics/soundField
    acoustics/analytic acoustics/sources
    acoustics/levelControl
    acoustics/meshSound acoustics/replay
    acoustics/compressible acoustics/explicitCompressible
    functionObjects aerosol/particles
    aerosol/domain aerosol/laws
    aerosol/parallel aerosol/turbulence
    aerosol/neighbours
    aerosol/initial aerosol/motion
    aerosol/collisions aerosol/coupling
    aerosol/timeStepping
    aerosol/aerosolCloud
"""


def folderOf(path, source):
    parts = path.relative_to(source).parts
    return "/".join(parts[:2] if parts[0] in ("acoustics", "aerosol") else parts[:1])


def faults(source):
    """Each include that does not look down, as 'a.C of x includes b.H of y'."""
    rank = {
        folder: i
        for i, line in enumerate(LAYERS.split("\n"))
        for folder in line.split()
    }
    files = sorted(
        path for path in source.rglob("*.[CH]") if "lnInclude" not in path.parts
    )
    folders = {path.name: folderOf(path, source) for path in files}

    found = []
    for path in files:
        own = folderOf(path, source)
        if own not in rank:
            found.append(f"{own} is in no layer")
            continue
        for name in re.findall(r'#include "([^"]+)"', path.read_text()):
            other = folders.get(name, own)
            down = rank.get(other, 0) < rank[own]
            # The particles know of the gas only its interface
            known = not (
                own.startswith("aerosol/") and other.startswith("acoustics/")
            ) or other == "acoustics/soundField"
            if other != own and not (down and known):
                found.append(f"{path.name} of {own} includes {name} of {other}")
    return found


def test_folders_include_only_lower_ones():
    assert not faults(ROOT/"src")


@pytest.mark.parametrize("path, include", [
    ("aerosol/particles/a.H", "aerosol/domain/b.H"),
    ("acoustics/harmonics/a.C", "acoustics/levelControl/b.H"),
    ("acoustics/sampling/a.C", "acoustics/harmonics/b.H"),
    ("aerosol/motion/a.C", "acoustics/meshSound/b.H"),
    ("acoustics/soundField/a.H", "aerosol/coupling/b.H"),
])
def test_an_include_that_looks_up_or_aside_is_found(tmp_path, path, include):
    for name, text in ((path, '#include "b.H"\n'), (include, "\n")):
        (tmp_path/name).parent.mkdir(parents=True)
        (tmp_path/name).write_text(text)
    [fault] = faults(tmp_path)
    assert fault == (
        f"{Path(path).name} of {Path(path).parent} includes b.H of "
        f"{Path(include).parent}"
    )


def test_a_folder_that_is_in_no_layer_is_found(tmp_path):
    (tmp_path/"aerosol/new").mkdir(parents=True)
    (tmp_path/"aerosol/new/a.H").write_text("\n")
    assert faults(tmp_path) == ["aerosol/new is in no layer"]
