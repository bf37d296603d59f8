"""What the files of the repository have promised."""

import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]
TUTORIALS = sorted(path.parent for path in ROOT.glob("tutorials/*/system"))

HEADER = "src/functionObjects/soundPressureLevel/soundPressureLevel.H"


def copyOfTools(folder):
    """A repository with nothing but the tools that check it."""
    for name in ("src", "applications", "tests", "tutorials", ".ci", "doc", "bin"):
        (folder/name).mkdir()
    for name in ("Allwmake", "Allwclean", ".shellcheckrc", ".flake8", "bin/format",
                 "bin/lint", "bin/environment"):
        shutil.copy(ROOT/name, folder/name)
    return folder


def lint(folder):
    check = subprocess.run(
        [folder/"bin/lint"], capture_output=True, text=True, check=False,
    )
    return check.returncode, check.stdout + check.stderr


def test_files_are_as_bin_lint_wants_them():
    status, report = lint(ROOT)
    assert status == 0, report


def test_lint_finds_faults_in_every_kind_of_file(tmp_path):
    folder = copyOfTools(tmp_path)
    status, report = lint(folder)
    assert status == 0, report
    for name, text in {
        "src/a.C": "int a; \n",
        "tests/a": "#!/bin/sh\nrm $1\n",
        "tutorials/a.py": "print(b)\n",
        "bin/a": "#!/usr/bin/env python3\nimport os\n",
    }.items():
        (folder/name).write_text(text)
        (folder/name).chmod(0o755)
    status, report = lint(folder)
    assert status == 1
    for complaint in (
        "src/a.C:1: tab, trailing blank", "tests/a:2:4: note: Double quote",
        "tutorials/a.py:1:7: F821 undefined name", "bin/a:2:1: F401 'os'",
    ):
        assert complaint in report


def test_manual_refuses_links_to_nowhere(tmp_path):
    folder = copyOfTools(tmp_path)
    shutil.copytree(ROOT/"doc/site", folder/"doc/site")
    for name in ("CITATION.cff", "bin/manual"):
        shutil.copy(ROOT/name, folder/name)
    (folder/"src/thing.C").write_text("")
    (folder/"src/thing.H").write_text((ROOT/HEADER).read_text())
    (folder/"doc/other.md").write_text("# Other\n\n## Place\n")

    def manual(text):
        (folder/"doc/index.md").write_text(f"# Title\n\n## Map\n\n{text}\n")
        made = subprocess.run(
            [folder/"bin/manual"], capture_output=True, text=True, check=False,
        )
        return made.returncode, made.stdout + made.stderr

    good = "[1](other.md) [2](other.md#place) [3](../src/thing.C) [4](../src/thing.H)"
    status, report = manual(good)
    assert status == 0, report
    site = folder/"doc/build/site"
    assert (site/"_static/katex/katex.min.js").exists()
    page = (site/"doc/index.html").read_text()
    header = re.search(r'href="\.\./(code/\S+\.html)">4</a>', page)[1]
    assert (site/header).exists()

    status, report = manual(f"{good} [5](no.md) [6](other.md#no) [7](../src/no.H)")
    assert status == 1
    for target in ("no.md", "other.md#no", "../src/no.H"):
        assert f"reference target not found: {target}" in report


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
        assert inside.parts[0] in (
            "0.orig", "constant", "system", "Allrun", "Allclean", "README.md",
            "README.png", "sweep",
        ) or inside.suffix in (".py", ".csv")


@pytest.mark.parametrize(
    "tool",
    [
        "format", "lint", "manual", "plotAgglomeration", "plotSound", "report",
        "renderCloud", "collisionKernels", "setup",
    ]
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


def test_citation_is_complete_and_of_the_last_release():
    """The fields of the Citation File Format 1.2.0, as far as they are used."""
    text = (ROOT/"CITATION.cff").read_text()
    fields = set(re.findall(r"(?m)^([a-z-]+):", text))
    required = {"cff-version", "message", "title", "authors"}
    optional = {
        "abstract", "commit", "contact", "date-released", "doi", "identifiers",
        "keywords", "license", "license-url", "preferred-citation", "references",
        "repository", "repository-artifact", "repository-code", "type", "url",
        "version",
    }
    assert required <= fields <= required | optional
    version = re.search(r"(?m)^version: (\S+)$", text)[1]
    date = re.search(r"(?m)^date-released: (\d{4}-\d\d-\d\d)$", text)[1]
    changes = (ROOT/"CHANGELOG.md").read_text()
    headings = re.findall(r"(?m)^## (.*)$", changes)
    assert headings[:2] == ["[Unreleased]", f"[{version}] - {date}"]


@pytest.mark.parametrize("library", ["acoustics", "aerosol"])
def test_folders_of_a_library_form_no_circle(library):
    """Each looks only down: by the headers that its files include."""
    files = [
        path for path in (ROOT/"src"/library).rglob("*.[CH]")
        if "lnInclude" not in path.parts and "Make" not in path.parts
    ]
    folder = {path: path.relative_to(ROOT/"src"/library).parts[0] for path in files}
    home = {path.name: folder[path] for path in files if path.suffix == ".H"}
    below = {name: set() for name in folder.values()}
    for path in files:
        for header in re.findall(r'#include "([^"]+)"', path.read_text()):
            below[folder[path]].add(home.get(header, folder[path]))
    assert len(below) > 5
    # Take away the lowest ones until none is left
    while below:
        lowest = {a for a, others in below.items() if not others - {a}}
        assert lowest, f"a circle among {sorted(below)}"
        below = {
            a: others - lowest for a, others in below.items() if a not in lowest
        }
