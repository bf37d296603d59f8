"""What bin/ and the plots of the tutorials do with what a run has left: tables
of several clouds, tables that are cut off, and nothing.
"""

import contextlib
import io
import runpy
import shutil
import subprocess
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[3]
TOOLS = ("plotAgglomeration", "collisionKernels")
PLOTS = sorted(ROOT.glob("tutorials/*/plot.py"))
EDGES = (0, 1e-6, 2e-6, 4e-6, np.inf)


class Results:
    """A case that has nothing but tables."""

    def __init__(self, path):
        self.path = path

    def tables(self, times, particles, cloud="aerosol"):
        """Those of a run; each particle that is gone was in a contact."""
        folder = self.path/"postProcessing"/cloud
        folder.mkdir(parents=True, exist_ok=True)
        gone = 1000 - np.asarray(particles)

        def write(name, header, rows):
            (folder/f"{name}.csv").write_text(
                header + "\n" + "".join(
                    ",".join(f"{x:.17g}" for x in row) + "\n" for row in rows
                )
            )

        write("agglomeration", "time_s,number,concentration_per_m3,efficiency,"
              "efficiency_PM2_5,CMD_m,MMD_m,GSD,dMax_m,contacts",
              [(t, N, 1e12*N, n/1000, 0, 1e-6, 2e-6, 1.5, 4e-6, n)
               for t, N, n in zip(times, particles, gone)])
        write("sizeDistribution", "time_s,lower_m,upper_m,number,mass_kg",
              [(t, lower, upper, N*(k == 1), 1e-15*N*(k == 1))
               for t, N in zip(times, particles)
               for k, (lower, upper) in enumerate(zip(EDGES, EDGES[1:]))])
        write("contacts", "time_s,id1,id2,d1_m,d2_m",
              [(0.5*(t0 + t1), 1, 2, 1.1e-6, 1.2e-6)
               for t0, t1, n0, n1 in zip(times, times[1:], gone, gone[1:])
               for _ in range(n1 - n0)])
        return folder

    def run(self, tool, *arguments, status=0):
        """What it prints, all of it: one line if it ends with an error."""
        said = io.StringIO()
        code = 0
        with pytest.MonkeyPatch.context() as patch, \
                contextlib.redirect_stdout(said), \
                contextlib.redirect_stderr(said):
            # In this process: matplotlib takes a second to import
            patch.chdir(self.path)
            patch.setattr(sys, "argv", [str(tool), *arguments])
            patch.syspath_prepend(Path(tool).parent)
            try:
                runpy.run_path(str(tool), run_name="__main__")
            except SystemExit as ended:
                code = ended.code
                if isinstance(code, str):
                    print(code, file=said)
                    code = 1
        plt.close("all")
        return self.check(said.getvalue(), code, status)

    @staticmethod
    def check(said, code, status):
        assert (code or 0) == status, said
        if status:
            errors = [line for line in said.splitlines()
                      if not line.startswith("NOTE: ")]
            assert len(errors) == 1 and errors[0].startswith("ERROR: "), errors
        return said

    def last(self, *arguments):
        """Time [ms] and number in the last row of plotAgglomeration."""
        text = self.run(ROOT/"bin/plotAgglomeration", *arguments)
        row = text.split("\n\n")[0].splitlines()[-1].split()
        scale = 1000 if "time [s]" in text else 1
        return scale*float(row[0]), int(row[1])

    def contacts(self, *arguments):
        text = self.run(ROOT/"bin/collisionKernels", *arguments)
        return int(text.split(" contacts in ")[0].splitlines()[-1])


@pytest.fixture(name="results")
def fixture_results(tmp_path):
    return Results(tmp_path)


@pytest.mark.parametrize("cut", [1, 60])
@pytest.mark.parametrize(
    "name", ["agglomeration", "sizeDistribution", "contacts"]
)
def test_a_last_row_that_is_cut_off_is_left_out(results, name, cut):
    folder = results.tables([0, 1, 2, 3], [1000, 990, 980, 970])
    file = folder/f"{name}.csv"
    text = file.read_text()
    file.write_text(text[:-min(cut, len(text.splitlines()[-1]))])
    note = "cut off"
    for tool in TOOLS:
        if (tool, name) == ("collisionKernels", "contacts"):
            said = results.run(ROOT/"bin"/tool, status=1)
            assert "contacts.csv has 29 contacts" in said
        elif (tool, name) == ("plotAgglomeration", "contacts"):
            results.run(ROOT/"bin"/tool)
            continue
        else:
            said = results.run(ROOT/"bin"/tool)
        assert note in said and file.name in said
    if name == "agglomeration":
        assert results.last() == (2000, 980)
    if name != "contacts":
        assert results.contacts() == 20


def test_clouds_are_named(results):
    results.tables([0, 1], [1000, 990], "node")
    assert results.last() == (1000, 990)
    assert results.contacts() == 10
    results.tables([0, 1], [1000, 980], "antinode")
    assert results.last("--cloud", "antinode") == (1000, 980)
    assert results.contacts(".", "antinode") == 20
    results.last()  # of each a picture
    assert {file.name for file in results.path.glob("*.png")} >= {
        "agglomeration_antinode.png", "agglomeration_node.png"}
    said = results.run(ROOT/"bin/collisionKernels", status=1)
    assert said.rstrip().endswith("antinode node")
    for tool, arguments in zip(TOOLS, (["--cloud", "anti"], [".", "anti"])):
        said = results.run(ROOT/"bin"/tool, *arguments, status=1)
        assert said.rstrip().endswith("antinode node")


@pytest.mark.parametrize("tool", TOOLS)
def test_what_is_wrong_is_one_line(results, tool):
    tool = ROOT/"bin"/tool
    assert "has the case been run" in results.run(tool, status=1)
    assert "--wrong" in results.run(tool, "--wrong", status=1)
    assert "nowhere" in results.run(tool, "nowhere", status=1)
    assert "third" in results.run(
        tool, *([".", "aerosol"]*(tool.name == "collisionKernels")), "third",
        status=1,
    )


@pytest.mark.parametrize("tool", TOOLS)
@pytest.mark.parametrize("name", ["agglomeration", "sizeDistribution"])
def test_tables_without_rows_or_with_others(results, tool, name):
    folder = results.tables([0, 1], [1000, 990])
    file = folder/f"{name}.csv"
    text = file.read_text()
    head, *rows = text.splitlines(True)
    contents = [
        "", head, head[:-1], "time_s,a\n0,1\n", head + rows[0] + "1,2\n",
        text.replace("1000", "many"), text.replace(",", " "), "\0"*100 + text,
        text.replace("time_s", "t"),
    ]
    if name == "sizeDistribution":
        contents.append(head + "".join(rows[1:]))  # a bin too few
    for content in contents:
        file.write_text(content)
        assert str(file) in results.run(ROOT/"bin"/tool, status=1)


def test_tables_of_cases_are_joined(results, tmp_path):
    """What scripts of users import, by the path that bin/environment sets."""
    pytest.importorskip("pandas")
    for seed, clouds in ((1, ("node", "antinode")), (2, ("aerosol",))):
        for k, cloud in enumerate(clouds):
            Results(tmp_path/f"seed{seed}").tables(
                [0, 1], [1000, 1000 - 10*seed - k], cloud)
    script = """
import acousticDEM
one = acousticDEM.table("seed2")
assert list(one["number"]) == [1000, 980], one
assert list(acousticDEM.table("seed2", "contacts").columns)[:2] == ["time_s", "id1"]
assert acousticDEM.clouds("seed1") == ["antinode", "node"]
both = acousticDEM.join(["seed1", "seed2"])
assert list(both.columns)[:4] == ["case", "cloud", "time_s", "number"], both
last = both[both["time_s"] == 1]
assert list(last["case"]) == ["seed1", "seed1", "seed2"], last
assert list(last["cloud"]) == ["antinode", "node", "aerosol"], last
assert list(last["number"]) == [989, 990, 980], last
assert len(acousticDEM.join("seed1", cloud="node")) == 2
for wrong in (lambda: acousticDEM.table("seed1"),
              lambda: acousticDEM.table("nowhere"),
              lambda: acousticDEM.join([]),
              lambda: acousticDEM.join("seed2", cloud="node"),
              lambda: acousticDEM.table("seed2", "breakages")):
    try:
        print(wrong())
    except acousticDEM.TableError as error:
        print("TableError:", error)
    else:
        raise AssertionError
"""
    done = subprocess.run(
        ["bash", "-c", '. "$0"/bin/environment && exec /usr/bin/python3 -c "$1"',
         ROOT, script],
        cwd=tmp_path, text=True, stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT, check=False,
    )
    assert done.returncode == 0, done.stdout
    assert done.stdout.count("TableError: ") == 5
    assert "antinode node" in done.stdout


def test_edges_of_classes(results):
    results.tables([0, 1], [1000, 990])
    tool = ROOT/"bin/collisionKernels"
    for edges in ("", "1e-6", "a,b", "2e-6,1e-6", "nan,1e-6"):
        assert "--classes" in results.run(tool, "--classes", edges, status=1)
    assert "--classes" in results.run(tool, "--classes", status=1)
    assert "10 contacts" in results.run(tool, "--classes", "1e-6,2e-6,4e-6")


@pytest.mark.parametrize("plot", PLOTS, ids=lambda f: f.parent.name)
def test_plots_without_results(tmp_path, plot):
    """In a copy of the tutorial that has not been run."""
    case = Results(tmp_path/"case")
    shutil.copytree(
        plot.parent, case.path, ignore=shutil.ignore_patterns(
            "log.*", "[0-9]*", "s[0-9]*", "clean", "sweep*", "postProcessing",
        ),
    )
    case.run(case.path/"plot.py", status=1)
