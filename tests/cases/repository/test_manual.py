"""The commands that the manual gives, against what there is."""

import fnmatch
import os
import re
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]
PAGES = {
    path.relative_to(ROOT): path.read_text()
    for path in sorted(ROOT.glob("doc/**/*.md"))
}


def commands(pattern):
    """(page, command) of all code in the text that matches."""
    return [
        (str(page), match)
        for page, text in PAGES.items() for match in re.findall(pattern, text)
    ]


def test_unit_tests_that_the_manual_names_exist():
    tests = Path(os.environ["ACOUSTICDEM_APPBIN"])/"acousticDEMUnitTests"
    if not tests.exists():
        pytest.skip("no unit tests: ./Allwmake -j --tests")
    named = commands(r"`(?:unit|full) '([^']*)'`")
    assert len(named) > 50
    listed = subprocess.run(
        [tests, "--gtest_list_tests"], capture_output=True, text=True, check=True,
    )
    suite = ""
    names = []
    for line in listed.stdout.splitlines():
        word = line.partition("#")[0].strip()
        if line.startswith(" "):
            names.append(suite + word)
        else:
            suite = word
    assert len(names) > 300
    assert not [
        f"{page}: {part}" for page, which in named for part in which.split(":")
        if not fnmatch.filter(names, part)
    ]


def test_cases_that_the_manual_names_exist():
    named = commands(r"`(?:cases|fullCases) ([^`]*)`")
    assert len(named) > 20
    missing = []
    for page, arguments in named:
        folders, _, which = arguments.partition(" -k ")
        for folder in folders.split():
            place = ROOT/"tests/cases"/folder
            if not place.exists():
                missing.append(f"{page}: {folder}")
            elif which:
                files = place.glob("test_*.py") if place.is_dir() else [place]
                texts = " ".join(file.read_text() for file in files)
                words = re.findall(r"\w+", which)
                if not any(
                    re.search(rf"def test\w*{word}", texts)
                    for word in words if word != "or"
                ):
                    missing.append(f"{page}: {arguments}")
    assert not missing


def test_entries_that_models_read_are_in_the_reference():
    """A model names all of its entries to requireOnly."""
    lists = [
        re.findall(r'"(\w+)"', entries)
        for file in ROOT.glob("src/**/*.C")
        for entries in re.findall(
            r"requireOnly\s*\([^{};]*\{([^{}]*)\}", file.read_text()
        )
    ]
    entries = {entry for names in lists for entry in names}
    assert len(entries) > 60
    reference = " ".join(
        text for page, text in PAGES.items() if page.parent.name == "reference"
    )
    assert not entries - set(re.findall(r"`(\w+)`", reference))


def test_programs_that_the_manual_names_exist():
    named = commands(
        r"(?<![\w/])((?:bin|tests|tutorials|doc)/[\w/.]*\w)(?![\w*])"
    )
    assert len(named) > 50
    missing = [
        f"{page}: {name}" for page, name in named
        if not (ROOT/name).exists() and not name.startswith("doc/build")
    ]
    assert not missing
