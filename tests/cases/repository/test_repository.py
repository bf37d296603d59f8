"""What the files of the repository have promised."""

import os
import re
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


def test_CDPATH_of_the_users_shell_does_not_matter(tmp_path):
    """`cd bin/..` would look there first, and print where it went."""
    elsewhere = tmp_path/"bin"
    elsewhere.mkdir()
    for CDPATH in (f".:{tmp_path}", str(tmp_path)):
        shell = subprocess.run(
            ["bash", "-c", 'CDPATH="$1"; cd() { builtin cd "$@" && echo here; }\n'
             '. bin/environment && echo "$ACOUSTICDEM_DIR"', "bash", CDPATH],
            cwd=ROOT, capture_output=True, text=True, check=False,
        )
        assert shell.stdout == f"{ROOT}\n"


def test_scripts_do_not_use_CDPATH():
    scripts = [
        *ROOT.glob("Allw*"), *ROOT.glob("bin/*"), *ROOT.glob("tests/*"),
        *ROOT.glob("tests/benchmarks/*"), *ROOT.glob("tutorials/*/All*"),
        ROOT/"tutorials/twoSpheres/sweep",
    ]
    texts = {path: path.read_text() for path in scripts if path.is_file()}
    entering = {path for path, text in texts.items() if 'cd "' in text}
    assert len(entering) > 20
    for path in entering:
        assert re.search(
            r"(?m)^( *CDPATH= (builtin )?cd |unset CDPATH)", texts[path]
        ), path
