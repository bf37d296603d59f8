"""bin/study: its runs, what a kill at any time leaves of them, its tables, and
the optimum of a function that is known. Most of it with a program in place of the
solver."""

import csv
import html.parser
import json
import os
import random
import re
import runpy
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from foamcase import ROOT

sys.path.insert(0, str(ROOT/"bin"))
import foamEntries  # noqa: E402
from responseSurface import Search  # noqa: E402

HERE = Path(__file__).resolve().parent
STUDY = ROOT/"bin"/"study"

HEADER = "FoamFile {{ version 2.0; format ascii; class dictionary; object {}; }}\n"
FILES = {
    "constant/acousticProperties": """
#include "$FOAM_CASE/system/values"
sound { type standingWave; frequency 1400; // [Hz]
    SPL $SPL; }
""",
    "constant/aerosolProperties": """
particles { density 2300; seed 1; }
wake { type none; }
""",
    "system/values": "SPL 147;\nmedian 2e-6;\n",
    "system/controlDict": """
application acousticDEMFoam;
startFrom latestTime;
endTime 1;
deltaT #eval{ 1.0/1400 };
""",
}


@pytest.fixture(name="case")
def fixture_case(tmp_path):
    folder = tmp_path/"case"
    for name, text in FILES.items():
        (folder/name).parent.mkdir(parents=True, exist_ok=True)
        (folder/name).write_text(HEADER.format(Path(name).name) + text)
    return folder


@pytest.fixture(name="environment")
def fixture_environment(tmp_path):
    (tmp_path/"bin").mkdir()
    solver = tmp_path/"bin"/"acousticDEMFoam"
    solver.symlink_to(HERE/"fakeSolver")
    return {**os.environ, "PATH": f"{tmp_path}/bin:{os.environ['PATH']}",
            "FAKE_CALLS": f"{tmp_path}/calls"}


def study(environment, *arguments, status=0):
    done = subprocess.run(
        [sys.executable, STUDY, *map(str, arguments)], env=environment,
        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT, text=True, check=False)
    assert done.returncode == status, done.stdout
    assert "Traceback" not in done.stdout, done.stdout
    return done.stdout


def in_this_process(*arguments):
    """The error with which it ends; quicker, as nothing is loaded again."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(sys, "argv", [str(STUDY), *map(str, arguments)])
        try:
            runpy.run_path(str(STUDY), run_name="__main__")
        except SystemExit as ended:
            return str(ended.code)
    return ""


def calls(environment):
    file = Path(environment["FAKE_CALLS"])
    return file.read_text().split() if file.exists() else []


def table(file):
    with Path(file).open(newline="") as text:
        return list(csv.DictReader(text))


VARY = ("--vary", "frequency=700,1400", "seed=1:2")


# Entries

def test_entries_keep_what_stands_around_them():
    text = """// a { b 1; }
a { b 1; /* c 2; */ c (1 2 3); "d.*" { e #eval{ $x + "1;" }; } }
#include "other"
$macro;
div(phi,U) Gauss linear;
code #{ if (x) { y; } #};
f $g;
"""
    found = {str(entry): entry.value for entry in foamEntries.entries(text, "f")}
    assert list(found) == ["f:a", "f:a/b", "f:a/c", "f:a/d.*", "f:a/d.*/e",
                           "f:div(phi,U)", "f:code", "f:f"]
    assert found["f:a/d.*/e"] == '#eval{ $x + "1;" }'
    new = foamEntries.changed(text, "f", ("a", "c"), "(4 5)")
    assert new == text.replace("(1 2 3)", "(4 5)")
    new = foamEntries.changed(new, "f", ("a", "d.*"), "{ e 2; }")
    assert '"d.*" { e 2; } }' in new and new.count("\n") == text.count("\n")
    new = foamEntries.changed(new, "f", ("a", "new"), "3")
    assert {str(e): e.value for e in foamEntries.entries(new, "f")}[
        "f:a/new"] == "3"


@pytest.mark.parametrize("text, line", [
    ("a { b 1;\n", 2), ("a 1;\n}\n", 2), ("a (1 2;\n", 2), ("a 1 }\n", 1),
])
def test_entries_of_a_broken_file(text, line):
    with pytest.raises(foamEntries.EntryError, match=f"f, line {line}: "):
        foamEntries.entries(text, "f")


@pytest.mark.parametrize("value", ["", "1; b 2", "(1 2", "1 // 2", "{ a 1; } 2"])
def test_values_that_are_none(value):
    with pytest.raises(foamEntries.EntryError, match="is no value"):
        foamEntries.changed("a 1;", "f", ("a",), value)


# Runs

def test_table_plots_and_page(case, environment):
    (case/"log.old").write_text("old")
    (case/"3").mkdir()
    said = study(environment, case, *VARY, "wake/type=none,Oseen",
                 "constant/aerosolProperties:Brownian={ type new; }")
    assert "the times 3 of the case are not copied" in said
    assert "has no Brownian: it is added" in said
    assert "8 runs, of which 8 are computed now" in said

    rows = table(case/"study"/"runs.csv")
    assert len(rows) == 8
    assert rows[0]["Brownian"] == "{ type new; }"
    for row in rows:
        run = case/"study"/row["folder"]
        text = (run/"constant"/"aerosolProperties").read_text()
        assert f"seed {row['seed']};" in text
        assert f"wake {{ type {row['type']}; }}" in text
        assert "Brownian { type new; }" in text
        # Macros, comments and what is not varied stay as they were
        sound = (run/"constant"/"acousticProperties").read_text()
        assert sound == (case/"constant"/"acousticProperties").read_text() \
            .replace("frequency 1400;", f"frequency {row['frequency']};")
        assert not (run/"log.old").exists() and not (run/"3").exists()

    points = table(case/"study"/"points.csv")
    assert len(points) == 4
    for point in points:
        values = [float(row["efficiency"]) for row in rows
                  if row["frequency"] == point["frequency"]
                  and row["type"] == point["type"]]
        assert point["seeds"] == "2"
        assert float(point["efficiency"]) == pytest.approx(np.mean(values))
        assert float(point["efficiency_error"]) == pytest.approx(
            np.std(values, ddof=1)/2**0.5)

    assert (case/"study"/"efficiency.png").stat().st_size > 5000
    page = (case/"study"/"study.html").read_text()
    html.parser.HTMLParser().feed(page)
    assert page.count("data:image/png;base64,") == 2
    assert not re.search(r'(src|href)="(?!data:)', page)
    assert "revision fake" in page

    # Nothing is computed twice, even by another study
    before = calls(environment)
    assert "0 are computed now and 8 were there" in study(
        environment, case, *VARY, "wake/type=none,Oseen",
        "constant/aerosolProperties:Brownian={ type new; }")
    assert "1 runs, of which 0 are computed now" in study(
        environment, case, "--vary", "seed=2", "wake/type=Oseen",
        "constant/aerosolProperties:Brownian={ type new; }",
        "sound/frequency=700")
    assert calls(environment) == before


def test_a_file_in_place_of_options(case, environment, tmp_path):
    (case/"system"/"studyDict").write_text(HEADER.format("studyDict") + """
vary
{
    seed    "1:2";
    sound/frequency (700 1400);
    model   // several entries at once
    {
        quiet   { wake { type none; } }
        wakes   { wake { type Oseen; } constant/aerosolProperties:range 20; }
    }
}
show (number efficiency);
""")
    said = study(environment, case, "--dry-run")
    assert "8 runs" in said and "quiet: constant/aerosolProperties:wake" in said
    assert not calls(environment) and not (case/"study").exists()
    said = study(environment, case)
    assert "frequency  model  seeds" in said
    names = [row["model"] for row in table(case/"study"/"runs.csv")]
    assert names == ["quiet", "wakes"]*4
    text = (case/"study"/"runs"/"seed=1_frequency=700_model=wakes"/"constant"
            / "aerosolProperties").read_text()
    assert "wake { type Oseen; }" in text and "range 20;" in text

    file = tmp_path/"study.json"
    file.write_text(json.dumps({"vary": {
        "seed": "1:2", "sound/frequency": [700, 1400],
        "model": {"wakes": {
            "wake": "{ type Oseen; }",
            "constant/aerosolProperties:range": 20}}}}))
    assert "4 runs, of which 0 are computed" in study(environment, case, file)


def test_what_is_wrong_is_said(case, environment):
    for arguments, message in (
        ([], "nothing is varied"),
        (["--vary", "frequenzy=1"], "the case has no entry frequenzy"),
        (["--vary", "Seed=1"], "no entry Seed; there is seed"),
        (["--vary", "type=a"], "constant/acousticProperties:sound/type"),
        (["--vary", "seed"], "--vary seed: write name=values"),
        (["--vary", "seed=5:1"], "'5:1' is no range"),
        (["--vary", "seed=1:2:x"], "'1:2:x' is no range"),
        (["--vary", "wake=Oseen"], "constant/aerosolProperties:wake is a"
         " dictionary"),
        (["--vary", "seed=1;2"], "'1;2' is no value"),
        (["--vary", "constant/none:a=1"], "the case has no file constant/none"),
        (["--vary", "constant/aerosolProperties:a/b=1"], "has no dictionary a;"
         " it has particles wake"),
        (["--optimise", "efficiency"], "say of what and over what"),
        (["--optimise", "efficiency", "--over", "frequency=7"], "no range to"
         " search"),
        (["--vary", "seed=1", "--jobs", "0"], "--jobs must be"),
        (["nothing.json"], "nothing.json: No such file"),
    ):
        said = in_this_process(case, *arguments)
        assert said.startswith("ERROR: ") and message in said, arguments
    for text, message in (
        ('{"vari": {}}', "has an entry vari; a study has commands"),
        ('{"vary": {]', "a.json: Expecting"),
        ('{"vary": 3}', "vary is no dictionary"),
        ('{"vary": {"a": {"b": 1}}}', "b is no dictionary of entries"),
        ("vary { seed (1 2; }", "a.json, line 1: "),
    ):
        (case/"a.json").write_text(text)
        assert message in in_this_process(case, case/"a.json"), text
    assert "is no case" in in_this_process(case/"system", *VARY)
    assert not calls(environment)
    said = study(environment, case, "--vary", "seed=1", "--show", "effic",
                 status=1)
    assert "no column effic; they have number efficiency" in said


def test_failed_runs_do_not_stop_the_others(case, environment):
    arguments = (case, "--vary", "frequency=-5,700", "seed=1:2")
    said = study(environment, *arguments, status=1)
    assert "2 of 4 runs have failed" in said
    assert said.count("frequency must be above 0, not -5") >= 2
    assert len(table(case/"study"/"runs.csv")) == 2
    assert "frequency must be above 0" in (case/"study"/"study.html").read_text()
    # They are tried again, the others are not
    n = len(calls(environment))
    study(environment, *arguments, status=1)
    assert len(calls(environment)) == n + 2


def test_a_changed_case_is_not_mixed(case, environment):
    study(environment, case, *VARY)
    before = (case/"study"/"runs.csv").read_text()
    file = case/"system"/"values"
    file.write_text(file.read_text().replace("147", "140"))
    n = len(calls(environment))
    said = study(environment, case, *VARY, status=1)
    assert "changed since are system/values" in said and "--anew" in said
    assert (case/"study"/"runs.csv").read_text() == before
    assert len(calls(environment)) == n

    study(environment, case, *VARY, "--results", case/"other")
    assert len(calls(environment)) == n + 4
    # Another folder of results in the case is none of its files
    assert "0 are computed" in study(environment, case, *VARY, "--results",
                                     case/"other")
    study(environment, case, *VARY, "--anew")
    assert len(calls(environment)) == n + 8
    assert not (case/"study"/"runs"/"frequency=700_seed=1"/"other").exists()


def test_goes_on_for_longer(case, environment):
    study(environment, case, *VARY)
    file = case/"system"/"controlDict"
    file.write_text(file.read_text().replace("endTime 1;", "endTime 2;"))
    said = study(environment, case, *VARY)
    assert said.count("goes on from 0.9 s") == 4
    row = table(case/"study"/"runs.csv")[0]
    text = (case/"study"/row["folder"]/"postProcessing"/"aerosol"
            / "agglomeration.csv").read_text()
    assert len(text.splitlines()) == 22
    # And shorter, where there is a row at the end
    n = len(calls(environment))
    file.write_text(file.read_text().replace("endTime 2;", "endTime 1.5;"))
    study(environment, case, *VARY)
    assert len(calls(environment)) == n
    value = table(case/"study"/"runs.csv")[0]["efficiency"]
    assert float(value) == float(text.splitlines()[16].split(",")[2])


def test_slim_runs_keep_tables_only(case, environment):
    study(environment, case, *VARY, "--slim")
    assert not list(case.glob("study/runs/*/0.*"))
    assert "0 are computed" in study(environment, case, *VARY)


@pytest.mark.parametrize("start", ["latestTime", "startTime"])
def test_killed_at_ten_moments(case, environment, start, tmp_path):
    """The study, one of its solvers, or both, by SIGKILL: the same table."""
    environment["FAKE_PAUSE"] = "0.05"
    file = case/"system"/"controlDict"
    file.write_text(file.read_text().replace("latestTime", start))
    whole = tmp_path/"whole"
    study({**environment, "FAKE_PAUSE": "0"}, case, *VARY, "--results", whole)

    choose = random.Random(start)
    delays = np.random.default_rng(5).permutation(np.linspace(0, 0.4, 10))
    arguments = [sys.executable, str(STUDY), str(case), *VARY, "--jobs", "2"]
    said = ""
    for k, delay in enumerate(delays):
        with subprocess.Popen(
                arguments, env=environment, stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT, text=True) as process:
            # From its first solver on, or from its start
            n, late = len(calls(environment)), time.monotonic() + 30
            while k % 5 and len(calls(environment)) == n \
                    and process.poll() is None:
                assert time.monotonic() < late
                time.sleep(0.01)
            time.sleep(delay)
            children = subprocess.run(
                ["pgrep", "-P", str(process.pid)], text=True, check=False,
                stdout=subprocess.PIPE).stdout.split()
            if k % 2 and children:
                os.kill(int(choose.choice(children)), signal.SIGKILL)
                time.sleep(0.05)
            process.kill()
            said += process.stdout.read()
        # What it had started ends with it
        late = time.monotonic() + 5
        while any(Path(f"/proc/{child}").exists() for child in children):
            assert time.monotonic() < late, children
            time.sleep(0.02)
        for folder in case.glob("study/runs/*[0-9]"):
            assert (folder/"run.json").exists()

    said += study(environment, case, *VARY)
    print(said)
    interrupted = said.count("goes on from") if start == "latestTime" \
        else said.count("was interrupted, and is run anew")
    assert interrupted > 2
    assert "goes on" not in said or start == "latestTime"
    for name in ("runs.csv", "points.csv"):
        assert (case/"study"/name).read_text() == (whole/name).read_text()


def test_a_killed_solver_is_a_run_that_goes_on(case, environment):
    environment["FAKE_PAUSE"] = "0.1"
    arguments = [case, "--vary", "seed=1", "frequency=700", "--jobs", "1"]
    with subprocess.Popen([sys.executable, STUDY, *arguments], env=environment,
                          stdout=subprocess.PIPE, text=True) as process:
        late = time.monotonic() + 30
        while not list(case.glob("study/runs/*/0.3")):
            assert time.monotonic() < late
            time.sleep(0.02)
        child = subprocess.run(["pgrep", "-P", str(process.pid)], text=True,
                               check=True, stdout=subprocess.PIPE).stdout
        os.kill(int(child), signal.SIGKILL)
        said = process.stdout.read()
    assert process.returncode == 1 and "killed by SIGKILL" in said
    assert "goes on from 0.3 s" in study(environment, *arguments)


def test_two_studies_at_a_time(case, environment):
    environment["FAKE_PAUSE"] = "0.1"
    with subprocess.Popen([sys.executable, STUDY, case, *VARY],
                          env=environment, stdout=subprocess.PIPE) as process:
        late = time.monotonic() + 30
        while not list(case.glob("study/runs/*")):
            assert time.monotonic() < late
            time.sleep(0.02)
        assert "another study is at work" in study(environment, case, *VARY,
                                                   status=1)
        process.send_signal(signal.SIGINT)
        process.wait()
    assert process.returncode == 1
    shutil.rmtree(case/"study")


def test_solver(box, environment):
    """With the solver itself, killed on its way: the same table as without."""
    environment["PATH"] = os.environ["PATH"]
    box.control("writeInterval", "25")
    box.model("wake", "type none;")
    arguments = (box.path, "--vary", "particles/seed=1:2", "SPL=140,150")
    whole = box.path.parent/"whole"
    said = study(environment, *arguments, "--results", whole)
    assert "4 are computed now" in said
    rows = table(whole/"runs.csv")
    assert len({row["efficiency"] for row in rows}) > 2
    points = {row["SPL"]: float(row["efficiency"])
              for row in table(whole/"points.csv")}
    assert points["150"] > points["140"] >= 0

    with subprocess.Popen([sys.executable, STUDY, *map(str, arguments)],
                          env=environment, stdout=subprocess.PIPE) as process:
        late = time.monotonic() + 60
        while not list(box.path.glob("study/runs/*/0.*")):
            assert time.monotonic() < late
            time.sleep(0.02)
        process.kill()
    said = study(environment, *arguments)
    print(said)
    assert (box.path/"study"/"runs.csv").read_text() \
        == (whole/"runs.csv").read_text()

    # What it says of an error is what the solver says
    said = study(environment, box.path, "--vary", "wake/type=unknown",
                 status=1)
    assert re.search(r"FAILED: acousticDEMFoam: .*unknown", said)


# The optimum

def bell(z):
    return 0.6*np.exp(-((z[0] - 0.37)/0.2)**2 - sum((z[1:] - 0.7)**2)/0.25)


@pytest.mark.parametrize("dimensions, most", [(1, 15), (2, 45)])
@pytest.mark.parametrize("noise", [0.005, 0.03])
def test_optimum_of_an_exact_function(dimensions, noise, most):
    """The errors that are said are those that are made; few points do."""
    pulls, off, points = [], [], []
    place = np.array([0.37, 0.7])[:dimensions]
    for k in range(40):
        random_ = np.random.default_rng(k)
        common = 2*noise*random_.normal(size=4)

        def evaluate(zs):
            return [bell(z) + common + noise*random_.normal(size=4) for z in zs]

        best = Search(evaluate, dimensions).maximise()
        pulls.append((best.place - place)/best.place_error)
        off.append((best.value - bell(place))/best.error)
        points.append(best.points)
        assert best.border == [0]*dimensions
    pulls, off = np.sqrt(np.mean(np.square(pulls), axis=0)), np.std(off)
    print(pulls, off, np.mean(points))
    assert (pulls < 2).all() and (pulls > 0.3).all()
    assert 0.6 < off < 1.8
    assert np.mean(points) < most


def test_optimum_at_the_end_of_the_range():
    best = Search(lambda zs: [[z[0] - (z[1] - 0.4)**2]*2 for z in zs],
                  2).maximise()
    assert best.border == [1, 0]
    assert best.place == pytest.approx([1, 0.4], abs=0.01)


def test_search(case, environment):
    """exp(-(ln(f/1400)/0.5)^2) with noise, by runs; and nothing is run twice."""
    arguments = (case, "--optimise", "efficiency", "--over",
                 "frequency=500:5000", "--vary", "seed=1:3")
    said = study(environment, *arguments)
    (best,) = table(case/"study"/"optimum.csv")
    x, error = float(best["frequency"]), float(best["frequency_error"])
    print(said)
    assert abs(x - 1400) < 40 and error < 30
    assert abs(float(best["efficiency"]) - 0.6) \
        < 4*float(best["efficiency_error"])
    assert int(best["runs"]) <= 45
    assert len(calls(environment)) == int(best["runs"])
    assert (case/"study"/"optimum.png").stat().st_size > 5000
    assert "Optimum" in (case/"study"/"study.html").read_text()
    first = (case/"study"/"optimum.csv").read_text()
    assert " 0 are computed now" in study(environment, *arguments)
    assert (case/"study"/"optimum.csv").read_text() == first
