"""Each tutorial explains itself, in the same form."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]
TUTORIALS = sorted(path.parent for path in ROOT.glob("tutorials/*/system"))


@pytest.mark.parametrize("tutorial", TUTORIALS, ids=lambda f: f.name)
def test_tutorial_has_a_README_with_a_picture(tutorial):
    text = (tutorial/"README.md").read_text()
    assert text.startswith(f"# {tutorial.name}: ")
    assert re.findall(r"(?m)^## (.*)", text) == [
        "Run", "What one sees", "The case", "What to change", "Theory",
    ]
    assert "    ./Allrun\n" in text
    assert len(text.splitlines()) <= 110
    picture = tutorial/re.search(r"!\[[^]]+\]\(([^)]+\.png)\)", text)[1]
    assert 10_000 < picture.stat().st_size < 100_000

    # What the run makes is not what the repository keeps
    for file in re.findall(r"`(\w+\.png)`", text):
        assert file != picture.name
