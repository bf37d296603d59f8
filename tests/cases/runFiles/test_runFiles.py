"""What surrounds a run: its tables, its lock, a disk that is full, its log."""

import fcntl
import os
import re
import signal
import subprocess
import time

import numpy as np
import pytest
from aerosolcase import csv
from foamcase import ROOT, FoamCase

SOLVER = "acousticDEMFoam"
LOCK = "acousticDEMFoam.lock"


def short(box, steps=10, interval=1000):
    """So many steps of 5 us, with a row for each."""
    box.control("deltaT", "5e-6")
    box.control("endTime", f"#eval{{ 5e-6*{steps} }}")
    box.control("writeInterval", str(interval))
    file = box.path/"constant/aerosolProperties"
    if "report" not in file.read_text():
        with file.open("a") as out:
            out.write("report { interval 5e-6; contacts no; }\n")
    return box


def flat(log):
    """In one line, and file names without the quotes of some versions."""
    return " ".join(log.replace('"', "").split())


def anew(box):
    for time_ in box.times():
        subprocess.run(["rm", "-r", box.path/time_], check=True)


def folder(box):
    return box.path/"postProcessing/aerosol"


def times_of(box, name="agglomeration"):
    """In steps."""
    return [round(t/5e-6, 3) for t in box.table(name)["time_s"]]


def test_a_table_is_read_by_anything(box):
    """One header, no padding, no comments."""
    box.replace("constant/aerosolProperties", "domain",
                "report { contacts yes; breakages yes; }\n\ndomain")
    box.aerosol("numberConcentration", "6e13")
    short(box).run(SOLVER)
    names = {file.name for file in folder(box).iterdir()}
    assert names >= {"agglomeration.csv", "sizeDistribution.csv",
                     "contacts.csv", "breakages.csv"}
    for name in names:
        header, *rows = (folder(box)/name).read_text().splitlines()
        assert re.fullmatch(r"time_s(,[A-Za-z]\w*)+", header)
        for row in rows:
            assert row.count(",") == header.count(",")
            assert re.fullmatch(r"[^\s,#]+(,[^\s,#]+)*", row)

    # The sizes are those of all particles
    numbers, sizes = box.table(), box.table("sizeDistribution")
    for t, n, m in zip(*(numbers[name] for name in
                         ("time_s", "number", "mass_kg"))):
        there = sizes["time_s"] == t
        if there.any():
            assert sizes["number"][there].sum() == n
            assert sizes["mass_kg"][there].sum() == pytest.approx(m, rel=1e-12)
    assert (sizes["lower_m"][0], sizes["upper_m"][-1]) == (0, np.inf)
    assert len(np.unique(sizes["time_s"])) == 2


def test_a_restart_continues_the_tables(box):
    """From the last time; from an earlier one; after a row that is cut off."""
    short(box, 10, 5).run(SOLVER)
    box.control("endTime", "8e-5")
    box.run(SOLVER)
    assert times_of(box) == list(range(17))
    assert sorted(set(times_of(box, "sizeDistribution"))) == [0, 5, 10, 15, 16]
    whole = (folder(box)/"agglomeration.csv").read_bytes()

    for cut in (1, 60, len(whole.splitlines()[-1]) + 1):
        (folder(box)/"agglomeration.csv").write_bytes(whole[:-cut])
        log = flat(box.run(SOLVER))
        assert (folder(box)/"agglomeration.csv").read_bytes() == whole
    assert "agglomeration.csv, which was cut off" in log

    box.control("startFrom", "startTime")
    box.control("startTime", "2.5e-5")
    box.control("endTime", "4e-5")
    assert re.search(r"Removed 11 rows of \S*agglomeration.csv after",
                     flat(box.run(SOLVER)))
    assert times_of(box) == list(range(9))
    assert whole.startswith((folder(box)/"agglomeration.csv").read_bytes())
    assert not list(folder(box).glob("*.previous"))


def test_a_table_that_is_not_written_any_longer_ends_where_the_run_starts(box):
    box.aerosol("numberConcentration", "6e13")
    box.replace("constant/aerosolProperties", "domain",
                "report { interval 5e-6; contacts yes; }\n\ndomain")
    short(box, 40, 20).run(SOLVER)
    assert times_of(box, "contacts")[-1] > 20 > times_of(box, "contacts")[0]
    box.replace("constant/aerosolProperties", "contacts yes", "contacts no")
    box.control("startFrom", "startTime")
    box.control("startTime", "1e-4")
    box.run(SOLVER)
    assert 0 < times_of(box, "contacts")[-1] <= 20


def test_a_new_run_sets_tables_aside(box):
    """Also one that is not written now, and but once; not a file of a user."""
    box.replace("constant/aerosolProperties", "domain",
                "report { interval 5e-6; contacts yes; }\n\ndomain")
    short(box).run(SOLVER)
    (folder(box)/"mine.csv").write_text("x,y\n1,2\n")
    first = (folder(box)/"agglomeration.csv").read_bytes()
    anew(box)
    box.replace("constant/aerosolProperties", "contacts yes", "contacts no")
    box.control("endTime", "2.5e-5")
    log = flat(box.run(SOLVER))
    assert "is now" in log and "agglomeration.csv.previous" in log
    assert (folder(box)/"agglomeration.csv.previous").read_bytes() == first
    assert times_of(box) == list(range(6))
    assert (folder(box)/"mine.csv").read_text() == "x,y\n1,2\n"
    assert not list(folder(box).glob("*_2*"))

    # A table with other columns
    file = folder(box)/"sizeDistribution.csv"
    file.write_text("time_s,below\n0,1\n")
    box.control("endTime", "5e-5")
    assert "has other columns than this run writes" in flat(box.run(SOLVER))
    assert file.with_name(file.name + ".previous").read_text().startswith(
        "time_s,below\n")
    assert times_of(box, "sizeDistribution")[0] == 5


@pytest.mark.parametrize("stop", ["writeNow", "noWriteNow", "nextWrite"])
def test_a_run_that_is_stopped_has_the_last_row(box, stop):
    """Rows are due at the beginning only."""
    box.replace("constant/aerosolProperties", "domain",
                "report { interval 1; }\n\ndomain")
    short(box, 1000, 7)
    box.control("stopAt", stop)
    box.run(SOLVER)
    steps = {"writeNow": 1, "noWriteNow": 1, "nextWrite": 7}[stop]
    assert times_of(box) == [0, steps]
    assert sorted(set(times_of(box, "sizeDistribution"))) == [0, steps]
    written = [round(float(t)/5e-6) for t in box.times()]
    assert written == ([0] if stop == "noWriteNow" else [0, steps])


def test_times_far_from_zero_have_enough_digits(box):
    short(box)
    box.control("startTime", "1500000")
    box.control("endTime", "1500000.00005")
    box.control("writeInterval", "1")
    (box.path/"1500000").mkdir()
    box.run(SOLVER)
    for name in ("agglomeration", "sizeDistribution"):
        times = np.unique(box.table(name)["time_s"])
        assert times == pytest.approx(1.5e6 + 5e-6*np.arange(11), abs=1e-9)


@pytest.mark.parametrize("link", [
    "postProcessing", "postProcessing/aerosol", "0/lagrangian", "0/uniform"
])
def test_a_link_to_nowhere_is_named(box, link):
    short(box)
    (box.path/link).parent.mkdir(exist_ok=True)
    (box.path/link).symlink_to("/nowhere/at/all")
    log = flat(box.run("timeout", "60", SOLVER, status=1))
    assert f"{link} is a link to a folder that is not there" in log


def test_a_file_in_the_way_is_named(box):
    box.write("postProcessing", "")
    log = flat(short(box).run(SOLVER, status=1))
    assert "postProcessing is a file where a folder has to be" in log


def tube(directory, periods, *edits):
    case = FoamCase("standingWaveTube", directory)
    case.replace(
        "system/controlDict", r"functions\s*\{",
        "functions { level { type soundPressureLevel; frequency 1400;"
        " libs (acousticDEMFunctionObjects); writeControl writeTime; }",
    )
    case.replace("system/controlDict", r"10\.0/", f"{periods}.0/")
    case.replace("system/controlDict", "stepsPerPeriod +200",
                 "stepsPerPeriod 50")
    for edit in edits:
        case.replace(*edit)
    case.run("blockMesh")
    case.run("setExprFields")
    return case


def level(case, name="soundPressureLevel"):
    return csv(case.path/f"postProcessing/level/{name}.csv")


def test_levels_of_a_restart(tmp_path):
    """They are continued, from an earlier time as well."""
    case = tube(tmp_path/"case", 3)

    def until(periods):
        case.replace("system/controlDict", r"endTime .*",
                     f"endTime #eval{{ {periods}.0/1400 }};")
        case.run(SOLVER)
        return level(case)["period"].tolist()

    assert until(3) == [1, 2, 3]
    assert until(5) == [1, 2, 3, 4, 5]
    for folder_ in case.path.glob("0.00*"):
        if float(folder_.name) > 2.5/1400:
            subprocess.run(["rm", "-r", folder_], check=True)
    assert until(3) == [1, 2, 3]


def test_levels_far_from_zero(tmp_path):
    """Times of periods that six digits do not tell apart."""
    case = tube(
        tmp_path/"case", 3,
        ("system/controlDict", "endTime .*",
         "endTime #eval{ 15000 + 3.0/1400 };"),
        ("system/controlDict", "writeControl writeTime;",
         "writeControl writeTime; writePrecision 6;"),
        ("system/controlDict", "startTime .*", "startTime 15000;"),
    )
    (case.path/"0").rename(case.path/"15000")
    case.run(SOLVER)
    times = level(case)["time_s"]
    assert np.diff(times) == pytest.approx(1/1400, rel=1e-6)


# The lock

def locked(box):
    file = (box.path/LOCK).open("w")
    file.write("process 123 on another\n")
    file.flush()
    fcntl.flock(file, fcntl.LOCK_EX)
    return file


def test_a_second_solver_is_refused(box):
    box.exact_numbers()
    short(box)
    with locked(box):
        log = flat(box.run(SOLVER, status=1))
        assert "process 123 on another" in log
        assert not (box.path/"postProcessing").exists()
        parallel = flat(
            box.run("bash", "-c", "mpirun -np 2 acousticDEMFoam -parallel",
                    status=1)
        ) if (box.path/"processor0").exists() else log
        assert "process 123 on another" in parallel

        # What changes nothing may be done
        assert "\nEnd\n" in box.run(SOLVER, "-dry-run")
        assert "\nEnd\n" in box.run(SOLVER, "-postProcess")

    # Whoever had the lock is gone: the file alone locks nothing
    assert "has not ended well" in flat(box.run(SOLVER))
    assert not (box.path/LOCK).exists()


def test_ranks_lock_the_case_once(box):
    """And one that is locked refuses them."""
    short(box)
    box.run_on(2)
    assert not (box.path/LOCK).exists()
    with locked(box):
        log = box.run("mpirun", "--oversubscribe", "-np", 2, SOLVER,
                      "-parallel", status=1)
        assert "process 123 on another" in flat(log)


def test_a_kill_leaves_no_lock(box):
    short(box, 1000000)
    with (box.path/"log").open("w") as log:
        run = subprocess.Popen(
            [f"{os.environ['ACOUSTICDEM_APPBIN']}/{SOLVER}"], cwd=box.path,
            stdout=log, stderr=subprocess.STDOUT,
        )
        try:
            end = time.monotonic() + 60
            table = box.path/"postProcessing/aerosol/agglomeration.csv"
            while not table.exists() and time.monotonic() < end:
                time.sleep(0.05)
            assert f"process {run.pid} on" in (box.path/LOCK).read_text()
            assert "Another" in box.run(SOLVER, status=1)
        finally:
            run.send_signal(signal.SIGKILL)
            run.wait()
    short(box)
    log = box.run(SOLVER)
    assert log.rstrip().endswith("End")
    assert "FOAM Warning" not in log.rsplit("Another", 1)[1]


def test_a_lock_that_cannot_be_written_is_told(box):
    (box.path/LOCK).mkdir()
    log = flat(short(box).run(SOLVER))
    assert "would not be noticed" in log


# A full disk: a limit of the size of files is its like

def limited(box, kilobytes):
    return flat(box.run(
        "bash", "-c", f"ulimit -f {kilobytes}; exec {SOLVER} >log.{SOLVER} 2>&1",
        status=1,
    ) + (box.path/f"log.{SOLVER}").read_text())


def test_a_full_disk_is_told_of_particles(box):
    log = limited(short(box), 5)
    assert re.search(r"Cannot write all of \S*0/lagrangian/aerosol/\w+: it has"
                     r" reached the limit of the size of files", log)


def test_a_full_disk_is_told_of_tables(box):
    box.particles([((0.0613, 0, 0), 2e-6)])
    log = limited(short(box, 1000, 100000), 20)
    assert re.search(r"Cannot write to \S*/agglomeration.csv: File too large",
                     log)


@pytest.mark.parametrize("kilobytes", [4, 5, 6])
def test_a_full_disk_is_told_of_fields(tmp_path, kilobytes):
    """Also if only the end of a file is missing, which OpenFOAM does not see"""
    case = tube(
        tmp_path/"case", 1,
        ("system/blockMeshDict", r"\(25 1 1\)", "(200 1 1)"),
        ("system/controlDict", r"(?s)functions\s*\{.*\n\}", ""),
        ("system/controlDict", r"endTime .*", "endTime 2e-5;"),
        ("system/controlDict", r"deltaT .*", "deltaT 1e-5;"),
        ("system/controlDict", r"writeInterval .*", "writeInterval 2;"),
    )
    log = limited(case, kilobytes)
    assert re.search(r"Cannot write all of \S*/2e-05/\w+: it has reached", log)


# The log, and when it is written

def test_the_log_begins_with_version_and_models(box):
    log = short(box).run(SOLVER)
    version = re.search(r"(?m)^version: (\S+)", (ROOT/"CITATION.cff").read_text())[1]
    changes = (ROOT/"CHANGELOG.md").read_text()
    assert version in " ".join(re.findall(r"(?m)^## .*", changes)[:2])
    begin = log.index(f"acousticDEM {version}")
    assert begin < log.index("Create time")
    assert re.search(r"(?m)^Sound: standingWave; frequency 1400; SPL 147;", log)
    assert re.search(r"(?m)^Gas: density 1.204 kg/m3, ", log)
    for line in (
        "drag         Stokes; slipCorrection Cunningham;",
        "wake         Oseen; range 20;",
        "timeStepping multipleTimeStep; kp 1; kc 0.1;",
        "particles    distribution; density 2300; size { lognormal; median",
        "not given, so by default: unsteadyDrag Brownian breakage frame coupling"
        " turbulence",
    ):
        assert f"\n    {line}" in log


@pytest.mark.parametrize("model", [
    "type conventional; kc 0.01;", "type multipleTimeStep; kp 0.01; kc 0.1;"
])
def test_long_steps_report(box, model):
    box.model("timeStepping", model)
    short(box, 1).control("deltaT", "2e-5")
    box.control("endTime", "2e-5")
    with (box.path/"system/controlDict").open("a") as out:
        out.write("reportInterval 0;\n")
    shares = re.findall(r"aerosol: (\d+) % of the fluid step to 2e-05 s",
                        box.run(SOLVER))
    assert len(shares) > 5
    assert shares == sorted(shares, key=int)


def test_the_end_is_written(box):
    """Seven steps, written each five; and on to twelve."""
    short(box, 7, 5).run(SOLVER)
    assert [round(float(t)/5e-6) for t in box.times()] == [0, 5, 7]
    box.control("endTime", "6e-5")
    assert "of time 3.5e-05" in flat(box.run(SOLVER))
    assert [round(float(t)/5e-6) for t in box.times()] == [0, 5, 7, 10, 12]


def test_times_of_another_run_are_told(box):
    short(box, 6, 2).run(SOLVER)
    box.control("startFrom", "startTime")
    box.control("endTime", "1e-5")
    log = flat(box.run(SOLVER))
    assert "later times already, from 1e-05 to 3e-05" in log


def test_steps_that_are_to_be_adjusted_are_refused(box):
    file = short(box).path/"system/controlDict"
    file.write_text(file.read_text() + "adjustTimeStep yes;\n")
    line = file.read_text().splitlines().index("adjustTimeStep yes;") + 1
    log = flat(box.run(SOLVER, status=1))
    assert "'adjustTimeStep' is on" in log and f"at line {line}" in log
    box.control("adjustTimeStep", "no")
    box.run(SOLVER)
