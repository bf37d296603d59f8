"""Every tutorial runs, shortened: Allrun in a copy, as README advises it."""

import os
import re
import shutil
import subprocess

import pytest
from foamcase import ROOT, FoamCase

TUTORIALS = sorted(ROOT.glob("tutorials/*/Allrun"))

# Long enough for something to plot: what is replaced in controlDict, in periods
SHORTER = {
    "aerosolAttenuation": {"20.0": "4.0"},
    "antinodeAndNode": {"20.0": "1.0"},
    "bestFrequency": {},  # smaller instead
    "ductAsh": {"140.0": "2.0"},
    "flyAshChamber": {
        "19.999": "0.999", "60.001": "2.001", "59.999": "1.999"
    },
    "isolatedParticle": {"3.0": "2.0"},
    "resonantChamber": {"80.0": "2.01"},
    "standingWaveTube": {"10.0": "1.1"},
    "streaming": {"60.0": "2.01"},
    "twoSpheres": {},  # one frequency instead
}

PICTURES = {
    "aerosolAttenuation": {"aerosolAttenuation.png"},
    "antinodeAndNode": {"antinodeAndNode.png"},
    "bestFrequency": {"bestFrequency.png"},
    "ductAsh": {"ductAsh.png"},
    "flyAshChamber": {"soundLevel.png", "agglomeration.png", "cloud.png"},
    "isolatedParticle": {"isolatedParticle.png"},
    "resonantChamber": {"resonantChamber.png"},
    "standingWaveTube": {"standingWaveTube.png"},
    "streaming": {"streaming.png"},
    "twoSpheres": {"twoSpheres.png"},
}


def script(case, name, status=0):
    """Run Allrun or Allclean and return what it says."""
    result = subprocess.run(
        [case.path/name], cwd="/", env=os.environ, check=False, text=True,
        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
    )
    assert result.returncode == status, result.stdout[-3000:]
    return result.stdout


def files(case):
    return {
        str(path.relative_to(case.path)): path.read_bytes()
        for path in case.path.rglob("*") if path.is_file()
    }


@pytest.mark.parametrize("allrun", TUTORIALS, ids=lambda f: f.parent.name)
def test_runs_in_a_copy(tmp_path, allrun):
    tutorial = allrun.parent.name
    case = FoamCase(tutorial, tmp_path/"case")
    for old, new in SHORTER[tutorial].items():
        case.replace(
            "system/controlDict", rf"{re.escape(old)}/\$f", f"{new}/$f"
        )
    (case.path/"README.png").write_text("what belongs to the tutorial")
    script(case, "Allclean")

    # Built already, and not to be built while tests run
    build = '"$root/bin/setup" && "$root/Allwmake" -j && '
    if tutorial == "flyAshChamber":
        case.replace("Allrun", re.escape(build), "")
        case.replace("system/controlDict", "(?<=endTime) +4;",
                     " #eval{ 3.5/$frequency };")
    if tutorial == "bestFrequency":
        case.replace("system/conditions", "3000;", "500;")
        case.replace("Allrun", "seed=1:3", "seed=1:2")
        case.replace("Allrun", "800:5:log", "800:2:log")
        case.replace("Allrun", "--optimise", "--most 7 --optimise")
        case.replace("system/controlDict", "0.0625;", "0.01;")
    if tutorial == "twoSpheres":
        case.replace("Allrun", "sweep 200 .* 5000", "sweep 1000")
    clean = files(case)

    script(case, "Allrun")
    for log in case.path.glob("log.*"):
        text = log.read_text(errors="replace")
        ended = text.replace("Finalising parallel run", "").rstrip()
        assert ended.endswith("End"), text[-3000:]
        assert "FOAM Warning" not in text, text
    pictures = {path.name for path in case.path.glob("*.png")}
    assert pictures >= PICTURES[tutorial]
    assert tutorial != "flyAshChamber" or (case.path/"report.html").exists()

    # Once more: nothing is touched
    after = files(case)
    assert "Allclean" in script(case, "Allrun", status=1)
    assert files(case) == after

    script(case, "Allclean")
    assert files(case) == clean


@pytest.mark.parametrize("allrun", TUTORIALS, ids=lambda f: f.parent.name)
def test_short_tries_do_not_warn(tmp_path, allrun):
    case = FoamCase(allrun.parent.name, tmp_path/"case")
    case.run("blockMesh")
    before = set(files(case))
    log = case.run("acousticDEMFoam", "-dry-run")
    assert "FOAM Warning" not in log, log

    # Only a log, for no run to go on from
    left = {name.split("/")[0] for name in set(files(case)) - before}
    assert left == {"log.acousticDEMFoam"}


def test_one_file_describes_the_chamber(tmp_path):
    """Frequency and level are those of system/chamber wherever they count."""
    case = FoamCase("flyAshChamber", tmp_path/"case")
    case.replace("system/chamber", r"(?m)^frequency .*", "frequency 1000;")
    case.replace("system/chamber", r"(?m)^SPL .*", "SPL 140;")
    case.replace("system/chamber", r"(?m)^length .*", "length 0.2145;")
    case.replace("system/chamber", r"(?m)^cells .*", "cells 36;")

    def value(file, entry):
        return case.run("foamDictionary", file, "-entry", entry, "-value")

    for file in sorted(case.path.rglob("*")):
        if (
            file.is_file()
            and file.name not in ("chamber", "README.md", "log.foamDictionary")
            and "polyMesh" not in file.parts
        ):
            assert not re.search(r"\b(1400|147)\b", file.read_text()), file

    # 200 Pa rms, u0 = sqrt(2) p/(rho c); the piston sees |sin(k L)| of it
    case.run("blockMesh")
    log = case.run("acousticDEMFoam", "-dry-run")
    assert "expected level 140 dB: p_rms 200 Pa" in log, log
    assert "50 steps per period" in log

    # The real mesh and the real end: 36 cells in 0.2145 m, four seconds
    cells = re.search(r"(\S+) cells per wavelength", log)[1]
    assert float(cells) == pytest.approx(0.3432*36/0.2145, rel=1e-3)
    way, speed = (
        float(re.search(pattern, log)[1])
        for pattern in (r"m/s: by (\S+) m until", r"settles at (\S+) m/s")
    )
    assert way == pytest.approx(4*speed, rel=1e-2)
    piston = value("0/U", "boundaryField/piston/velocityAmplitude")
    assert float(piston.split()[-1]) == pytest.approx(0.4840, rel=1e-3)
    centre = value("constant/aerosolProperties", "domain/centre")
    assert "0.128687" in centre


FIELDS = sorted(ROOT.glob("tutorials/*/0.orig"))


def parsed_by_ParaView(file, case):
    """A file and what it includes, as ParaView reads them: it knows $FOAM_CASE,
    but not ${...}, and passes over a file that is not there if it may."""
    text = re.sub(r"(?s)//[^\n]*|/\*.*?\*/", "", file.read_text())
    for directive, name in re.findall(r'(?m)^\s*#(\w+)\s*(?:"([^"]*)")?', text):
        other = case/name.replace("$FOAM_CASE/", "")
        if directive == "include":
            text += parsed_by_ParaView(other, case)
        elif other.is_file():
            assert directive == "includeIfPresent", f"{file}: #{directive}"
            text += parsed_by_ParaView(other, case)
    return text


@pytest.mark.parametrize("fields", FIELDS, ids=lambda f: f.parent.name)
def test_others_can_read_the_fields_at_the_start(fields):
    """No arithmetics, and each variable has a value."""
    for file in fields.iterdir():
        text = parsed_by_ParaView(file, fields.parent)
        directives = set(re.findall(r"#(\w+)", text))
        assert directives <= {"include", "includeIfPresent"}, file
        for name in re.findall(r"\$(\w+)(?=\s*;)", text):
            assert re.search(rf"(?m)^\s*{name}\s", text), f"{file}: ${name}"


def test_ParaView_reads_the_fields_at_the_start(tmp_path):
    if not (shutil.which("pvpython") and shutil.which("xvfb-run")):
        pytest.skip("ParaView is not installed")
    cases = []
    for fields in FIELDS:
        case = FoamCase(fields.parent.name, tmp_path/fields.parent.name)
        case.run("blockMesh")
        (case.path/"case.foam").touch()
        cases.append(str(case.path))
    script = tmp_path/"read.py"
    script.write_text("""
import sys
from paraview import servermanager
from paraview.simple import OpenFOAMReader

for case in sys.argv[1:]:
    reader = OpenFOAMReader(FileName=case + "/case.foam")
    reader.SkipZeroTime = 0
    reader.Refresh()
    reader.UpdatePipelineInformation()
    reader.MeshRegions = ["internalMesh"]
    reader.CellArrays = ["p", "T", "U"]
    reader.UpdatePipeline(0)
    data = servermanager.Fetch(reader).GetBlock(0).GetCellData()
    names = [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]
    print("FIELDS", *sorted(names))
""")
    environment = {key: value for key, value in os.environ.items()
                   if key != "PYTHONPATH"}
    environment["PATH"] = "/usr/bin:" + environment["PATH"]
    read = subprocess.run(
        ["xvfb-run", "-a", "pvpython", script, *cases], env=environment,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
        check=False,
    ).stdout
    assert read.count("FIELDS T U p") == len(cases) > 3, read
    assert "ERR|" not in read, read
