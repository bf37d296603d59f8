"""What all case tests share: the check of what they need, and cases to copy."""

import os
from pathlib import Path

import pytest
from aerosolcase import AerosolCase

ROOT = Path(__file__).resolve().parents[2]


def pytest_sessionstart():
    if os.environ.get("ACOUSTICDEM_DIR") != str(ROOT):
        pytest.exit(f"first source the environment: . {ROOT}/bin/environment", 2)
    if not (Path(os.environ["ACOUSTICDEM_APPBIN"])/"acousticDEMFoam").exists():
        pytest.exit("there is no solver: run ./Allwmake -j first", 2)


@pytest.fixture(scope="session", name="meshed")
def fixture_meshed(tmp_path_factory):
    """The base case with its mesh, to copy from."""
    case = AerosolCase(tmp_path_factory.mktemp("base")/"analyticBox")
    case.run("blockMesh")
    return case.path


@pytest.fixture(name="box")
def fixture_box(tmp_path, meshed):
    """A copy of the base case, with its mesh, for the test to change."""
    return AerosolCase(tmp_path/"case", meshed)
