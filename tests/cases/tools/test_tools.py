"""What bin/ and the plots of the tutorials do with what a run has left: tables
of several runs, tables that are cut off, folders that are copies, and nothing.
"""

import contextlib
import io
import os
import runpy
import shutil
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[3]
TOOLS = ("plotAgglomeration", "collisionKernels")
PLOTS = sorted(ROOT.glob("tutorials/*/plot.py"))
EDGES = (1e-6, 2e-6, 4e-6)


class Results:
    """A case that has nothing but tables."""

    def __init__(self, path):
        self.path = path

    def tables(self, start, number, times, particles, run=None,
               cloud="aerosol"):
        """Those of a run; each particle that is gone was in a contact."""
        folder = self.path/"postProcessing"/cloud/start
        folder.mkdir(parents=True, exist_ok=True)
        suffix = "" if number == 1 else f"_{number}"
        head = f"# Run             : {run}\n" if run else ""
        gone = 1000 - np.asarray(particles)

        def write(name, header, rows):
            (folder/f"{name}{suffix}.dat").write_text(
                head + header + "".join(
                    "\t".join(f"{x:.17g}" for x in row) + "\n" for row in rows
                )
            )

        write("agglomeration", "# time[s] particles concentration[1/m3] ...\n",
              [(t, N, 1e12*N, n/1000, 0, 1e-6, 2e-6, 1.5, 4e-6, n, 1, 0, 0, 0)
               for t, N, n in zip(times, particles, gone)])
        write("sizeDistribution", "# edges[m] " + " ".join(map(str, EDGES))
              + "\n# time[s] below bin1 bin2 above\n",
              [(t, 0, N, 0, 0) for t, N in zip(times, particles)])
        write("contacts", "# time[s] id1 id2 d1[m] d2[m] ...\n",
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


@pytest.mark.parametrize("numbered", [True, False])
def test_the_last_run_counts_whatever_the_times_of_the_files(
    results, numbered
):
    """Twelve runs from 0: _10 is after _9. A copy has the times reversed."""
    for k in range(1, 13):
        folder = results.tables("0", k, [0, 1, 2], [1000, 990, 900 + k],
                                k if numbered else None)
    for file in folder.iterdir():
        k = int(file.stem.split("_")[1]) if "_" in file.stem else 1
        os.utime(file, (2e9 - k, 2e9 - k))
    assert results.last() == (2000, 912)
    assert results.contacts() == 1000 - 912


def test_what_a_run_did_again_counts(results):
    """From 0 to 4, from 2 to 6, and anew from 1 to 3: that of 2 is over."""
    results.tables("0", 1, [0, 1, 2, 3, 4], [1000, 990, 980, 970, 960], 1)
    results.tables("2", 1, [2, 3, 4, 5, 6], [980, 971, 961, 951, 941], 2)
    assert results.last() == (6000, 941)
    assert results.contacts() == 59
    results.tables("1", 1, [1, 2, 3], [990, 985, 975], 3)
    assert results.last() == (3000, 975)
    assert results.contacts() == 25


def test_times_far_from_zero(results):
    """Steps of 10 us after 1.5e6 s are told apart."""
    times = 1.5e6 + 1e-5*np.arange(5)
    results.tables("1500000", 1, times, [1000, 990, 980, 970, 960], 1)
    results.tables("1500000.00002", 1, times[2:], [980, 975, 974], 2)
    assert results.last()[1] == 974
    assert results.contacts() == 26


@pytest.mark.parametrize("cut", [1, 60])
@pytest.mark.parametrize(
    "name", ["agglomeration", "sizeDistribution", "contacts"]
)
def test_a_last_row_that_is_cut_off_is_left_out(results, name, cut):
    folder = results.tables("0", 1, [0, 1, 2, 3], [1000, 990, 980, 970], 1)
    file = folder/f"{name}.dat"
    text = file.read_text()
    file.write_text(text[:-min(cut, len(text.splitlines()[-1]))])
    note = "cut off"
    for tool in TOOLS:
        if (tool, name) == ("collisionKernels", "contacts"):
            said = results.run(ROOT/"bin"/tool, status=1)
            assert "contacts.dat has 29 contacts" in said
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

    # The next run goes on from there
    results.tables("2", 1, [2, 3], [980, 960], 2)
    assert results.last() == (3000, 960)
    assert results.contacts() == 40


@pytest.mark.parametrize("name", ["0_before", "0_1", "old", "0.5 (copy)"])
def test_folders_and_files_that_are_copies_are_passed_over(results, name):
    folder = results.tables("0", 1, [0, 1, 2], [1000, 990, 980], 1)
    shutil.copytree(folder, folder.parent/name)
    shutil.copy(folder/"agglomeration.dat", folder/"agglomeration_old.dat")
    assert results.last() == (2000, 980)
    assert results.contacts() == 20


def test_clouds_are_named(results):
    results.tables("0", 1, [0, 1], [1000, 990], 1, "node")
    assert results.last() == (1000, 990)
    assert results.contacts() == 10
    results.tables("0", 1, [0, 1], [1000, 980], 1, "antinode")
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
    folder = results.tables("0", 1, [0, 1], [1000, 990], 1)
    file = folder/f"{name}.dat"
    text = file.read_text()
    head = "".join(line for line in text.splitlines(True) if line[0] == "#")
    contents = [
        "", head, head + "0 1\n1 2\n", head + "0 1 2\n1 2\n2 3 4\n",
        text.replace("1000", "many"), "\0"*100 + text,
    ]
    if name == "sizeDistribution":
        contents.append(text.replace("# edges", "# borders"))
    for content in contents:
        file.write_text(content)
        assert str(file) in results.run(ROOT/"bin"/tool, status=1)


def test_edges_of_classes(results):
    results.tables("0", 1, [0, 1], [1000, 990], 1)
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
