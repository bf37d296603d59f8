"""A law in a library of one's own, compiled outside the repository."""

import os
import shutil
import subprocess
from pathlib import Path

import pytest
from aerosolcase import AerosolCase
from foamcase import ROOT

HERE = Path(__file__).resolve().parent


@pytest.fixture(name="library")
def fixture_library(tmp_path):
    """The folder of the library, built as CONTRIBUTING says."""
    source = tmp_path/"slowStick"
    shutil.copytree(
        HERE/"slowStick", source, ignore=shutil.ignore_patterns("linux*")
    )
    result = subprocess.run(
        ["bash", "-c", '. "$0"/bin/environment; export FOAM_USER_LIBBIN="$1"; '
         'mkdir -p "$1" && wmake "$2"', ROOT, tmp_path/"lib", source],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
        check=False,
    )
    assert result.returncode == 0, result.stdout[-3000:]
    return tmp_path/"lib"


def test_is_selected_and_called(tmp_path, meshed, library, monkeypatch):
    """With a limit above all speeds all stick, with one below none does."""
    monkeypatch.setenv(
        "LD_LIBRARY_PATH", f"{library}:{os.environ['LD_LIBRARY_PATH']}"
    )
    left = {}

    for contact in ("stick", "slowStick; limit 1e3", "slowStick; limit 1e-9"):
        case = AerosolCase(tmp_path/str(len(left)), meshed)
        case.model("contact", f"type {contact};")
        case.aerosol("min", "1e-6")
        case.aerosol("max", "5e-6")
        case.aerosol("numberConcentration", "80e12")
        case.aerosol("length", "0.3e-3")
        case.control("endTime", "#eval{ 0.2/$frequency }")
        case.control("writeInterval", "20")
        with (case.path/"system/controlDict").open("a") as file:
            file.write('libs ("libmine.so");\n')
        case.run("acousticDEMFoam")
        left[contact] = len(case.cloud(case.times()[-1])["id"])

    print(left)
    everything, all_slow, none_slow = left.values()
    assert everything < 2160
    assert all_slow == everything
    assert none_slow == 2160
