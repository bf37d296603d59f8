"""A restart continues the sound: the old time levels, and the piston's phase."""

import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.append(str(Path(__file__).resolve().parents[1]))
from foamcase import FoamCase  # noqa: E402

PISTON = """left
    {
        type            acousticPiston;
        velocityAmplitude 0.02;
        frequency       table ((0 1000) (0.01 1500));
        rampPeriods     1;
    }"""


def sound(directory, interrupt, forget=(), kind="compressible"):
    """Pressure at the wall over three periods, interrupted or not."""
    case = FoamCase("standingWaveTube", directory)
    case.replace("constant/acousticProperties", "type +compressible",
                 f"type {kind}")
    case.replace("0/U", r"left\s*\{[^}]*\}", PISTON)
    case.replace("system/controlDict", "ascii", "binary")
    case.run("blockMesh")
    case.run("setExprFields")

    if interrupt:
        case.replace("system/controlDict", "10.0/", "2.0/")
        case.run("acousticDEMFoam")
        case.replace("system/controlDict", "2.0/", "3.0/")

        last = max(
            (d for d in case.path.iterdir() if d.name[0].isdigit()
             and d.name != "0.orig"),
            key=lambda d: float(d.name),
        )
        for field in forget:
            (last/field).unlink()
    else:
        case.replace("system/controlDict", "10.0/", "3.0/")

    case.run("acousticDEMFoam")

    return case.probes("history", "p")[1][:, 0]


@pytest.fixture(scope="module", name="reference")
def fixture_reference(tmp_path_factory):
    return sound(tmp_path_factory.mktemp("sound")/"case", interrupt=False)


def jump(restarted, reference):
    assert len(restarted) == len(reference)
    size = np.abs(restarted - reference).max()
    print(f"jump {size} Pa")
    return size/np.abs(reference - 101325).max()


def test_continues_as_if_nothing_had_happened(tmp_path, reference):
    restarted = sound(tmp_path/"case", interrupt=True)

    assert jump(restarted, reference) < 1e-6


def test_continues_explicitly_too(tmp_path):
    whole, parts = (
        sound(tmp_path/str(interrupt), interrupt, kind="explicitCompressible")
        for interrupt in (False, True)
    )

    # No old levels; but the name of the time, and so the piston's phase, has
    # ten digits
    assert jump(parts, whole) < 1e-8


LEVELS = ["U_0", "p_0", "T_0", "rho_0", "phi_0"]


def test_needs_the_old_levels_for_that(tmp_path, reference):
    restarted = sound(
        tmp_path/"case", interrupt=True, forget=[*LEVELS, "phi"],
    )

    assert jump(restarted, reference) > 1e-3


@pytest.mark.parametrize("forget", [LEVELS, ["T_0"], ["phi"]])
def test_does_not_do_without_some_of_them(tmp_path, forget):
    with pytest.raises(AssertionError, match="some are missing"):
        sound(tmp_path/"case", interrupt=True, forget=forget)
