"""The figures of the manual are what their scripts draw."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]
FIGURES = ROOT/"doc/figures"
NAMES = sorted(
    file.stem for file in FIGURES.glob("*.py")
    if "def figure()" in file.read_text()
)


def draw(*arguments, status=0):
    drawn = subprocess.run(
        [sys.executable, "-B", FIGURES/"draw", *arguments],
        capture_output=True, text=True, check=False,
    )
    assert drawn.returncode == status, drawn.stdout + drawn.stderr
    return drawn.stdout + drawn.stderr


def texts(picture):
    """What the reader reads: not the curves, of which other processors may
    round the last digit otherwise."""
    found = re.findall(r"<text[^>]*>(.*?)</text>", picture, re.DOTALL)
    assert len(found) > 5
    return found


def test_each_figure_has_its_script():
    assert len(NAMES) > 5
    assert sorted(file.stem for file in FIGURES.glob("*.svg")) == NAMES


def test_one_command_draws_all_of_them(tmp_path):
    folders = [tmp_path/"once", tmp_path/"again"]
    for folder in folders:
        folder.mkdir()
        draw("--into", folder)
    for name in NAMES:
        one, other = ((folder/f"{name}.svg").read_text() for folder in folders)
        assert one == other
        assert len(one) < 100_000
        assert texts(one) == texts((FIGURES/f"{name}.svg").read_text())
        assert "dc:date" not in one


def test_layers_are_the_folders_of_src():
    """After a move: doc/figures/draw layers"""
    drawn = set(re.findall(
        r'id="(src/\w+/\w+)"', (FIGURES/"layers.svg").read_text()
    ))
    there = {
        str(path.relative_to(ROOT)) for library in ("aerosol", "acoustics")
        for path in (ROOT/"src"/library).iterdir()
        if path.is_dir() and path.name not in ("Make", "lnInclude")
    }
    assert drawn == there - {"src/acoustics/soundField"}


def test_the_table_of_models_is_what_its_script_prints():
    """After a change: doc/figures/models.py"""
    printed = subprocess.run(
        [sys.executable, "-B", FIGURES/"models.py"],
        capture_output=True, text=True, check=True,
    ).stdout
    assert printed.count("\n| 5 um | 1.6 | 2.5 | `history` |") == 1
    assert printed in (ROOT/"doc/howTo/models.md").read_text()


@pytest.mark.parametrize("arguments, message", [
    (["--into", "/nowhere"], "there is no folder /nowhere"),
    (["wake"], "there is no figure wake; there are: contact,"),
])
def test_a_mistake_is_named(arguments, message):
    assert message in draw(*arguments, status=1)
