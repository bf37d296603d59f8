"""What all case tests share: the check of what they need, and cases to copy."""

import os
from pathlib import Path

import pytest
from aerosolcase import AerosolCase

ROOT = Path(__file__).resolve().parents[2]


# Memory that was given back is overwritten, so that its further use shows
os.environ.setdefault("MALLOC_PERTURB_", "85")


def pytest_addoption(parser):
    parser.addoption(
        "--full", action="store_true",
        help="also the tests that take longer, with the statistics of"
        " doc/verification.md",
    )


def pytest_configure(config):
    config.addinivalue_line("markers", "full: runs only with --full")


def pytest_collection_modifyitems(config, items):
    if not config.getoption("full"):
        for item in items:
            if item.get_closest_marker("full"):
                item.add_marker(pytest.mark.skip(reason="only with --full"))


def pytest_sessionstart():
    if os.environ.get("ACOUSTICDEM_DIR") != str(ROOT):
        pytest.exit(f"first source the environment: . {ROOT}/bin/environment", 2)
    if not (Path(os.environ["ACOUSTICDEM_APPBIN"])/"acousticDEMFoam").exists():
        pytest.exit("there is no solver: run ./Allwmake -j first", 2)


@pytest.fixture(name="full")
def fixture_full(request):
    """Whether the statistics are to be those of doc/verification.md."""
    return request.config.getoption("full")


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
