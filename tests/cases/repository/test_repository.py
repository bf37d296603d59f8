"""What the files of the repository have promised."""

import os
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]
TUTORIALS = sorted(path.parent for path in ROOT.glob("tutorials/*/system"))


def test_format():
    check = subprocess.run(
        [ROOT/"bin/format", "--check"],
        capture_output=True, text=True, check=False,
    )
    assert check.returncode == 0, check.stdout + check.stderr


@pytest.mark.parametrize("tutorial", TUTORIALS, ids=lambda f: f.name)
def test_tutorial_has_a_short_Allrun(tutorial):
    allrun = tutorial/"Allrun"
    assert os.access(allrun, os.X_OK)
    assert len(allrun.read_text().splitlines()) <= 12
    assert os.access(tutorial/"Allclean", os.X_OK)


@pytest.mark.parametrize("tutorial", TUTORIALS, ids=lambda f: f.name)
def test_tutorial_has_no_results(tutorial):
    files = subprocess.run(
        ["git", "ls-files", tutorial],
        cwd=ROOT, capture_output=True, text=True, check=False,
    )
    if files.returncode:
        pytest.skip("this is no checkout of git")
    for name in files.stdout.split():
        inside = (ROOT/name).relative_to(tutorial)
        assert inside.suffix != ".png"
        assert inside.parts[0] in (
            "0.orig", "constant", "system", "Allrun", "Allclean", "README.md",
            "sweep",
        ) or inside.suffix in (".py", ".csv")


@pytest.mark.parametrize(
    "tool",
    ["format", "plotAgglomeration", "renderCloud", "collisionKernels", "setup"]
)
def test_tools_explain_themselves(tool):
    helped = subprocess.run(
        [ROOT/"bin"/tool, "--help"],
        capture_output=True, text=True, check=False,
    )
    assert helped.returncode == 0, helped.stderr
    assert f"Usage: bin/{tool}" in helped.stdout
