"""The function object soundPressureLevel against a standing wave of 120 dB.

The tube is at its fundamental, 0.1 % off the 1400 Hz of the analysis, and
loses 0.005 % per period.
"""

import re
import shutil
import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.append(str(Path(__file__).resolve().parents[1]))
from aerosolcase import csv  # noqa: E402
from foamcase import FoamCase  # noqa: E402

LENGTH = 0.1226
SOUND_SPEED = np.sqrt(1005/(1005 - 8314.47/28.96)*8314.47/28.96*293.15)
DENSITY = 101325/(8314.47/28.96*293.15)
AMPLITUDE = 28.28

LEVEL = f"""functions
{{
    level
    {{
        type            soundPressureLevel;
        libs            (acousticDEMFunctionObjects);
        writeControl    writeTime;
        frequency       1400;
        harmonics       2;
        coefficients    yes;
        probeLocations
        (
            (0 0.005 0.005) ({LENGTH/2} 0.005 0.005) ({LENGTH/4} 0.005 0.005)
        );
    }}
"""


FOLDER = "postProcessing/level"


def table(case):
    """The columns of the table, and those of the points with their number."""
    rows = csv(case.path/FOLDER/"soundPressureLevel.csv")
    points = csv(case.path/FOLDER/"soundPressureLevelAtPoints.csv")
    for k in range(3):
        for name, column in points.items():
            rows[f"{name}({k})"] = column[points["point"] == k]
    return rows


def run(directory, solver="acousticDEMFoam", steps="200", ranks=1):
    case = FoamCase("standingWaveTube", directory)
    case.replace("system/controlDict", "10.0/", "3.0/")
    case.replace("system/controlDict", r"functions\s*\{", LEVEL)
    case.replace(
        "system/controlDict", "stepsPerPeriod +200", f"stepsPerPeriod {steps}"
    )
    case.replace(
        "system/controlDict", r"writeInterval +\$stepsPerPeriod",
        "writeInterval 150"
    )
    case.run("blockMesh")
    case.run("setExprFields")
    if ranks > 1:
        case.write(
            "system/decomposeParDict",
            "FoamFile { version 2.0; format ascii; class dictionary;"
            " object decomposeParDict; }\n"
            f"numberOfSubdomains {ranks}; method simple;"
            f" simpleCoeffs {{ n ({ranks} 1 1); delta 0.001; }}\n",
        )
        case.run("decomposePar")
        case.run(
            "mpirun", "--allow-run-as-root", "--oversubscribe", "-np", ranks,
            solver, "-parallel",
        )
    else:
        case.run(solver)
    return case


@pytest.fixture(scope="module", name="tube")
def fixture_tube(tmp_path_factory):
    return run(tmp_path_factory.mktemp("level")/"case")


def check(rows):
    level = 20*np.log10(AMPLITUDE/np.sqrt(2)/20e-6)
    u0 = AMPLITUDE/(DENSITY*SOUND_SPEED)

    # At the wall, in the middle and between
    assert rows["period"].tolist() == [1, 2, 3]
    assert rows["time_s"]*1400 == pytest.approx([1, 2, 3], rel=1e-9)
    assert (rows["frequency_Hz"] == 1400).all()
    assert (rows["x_m(2)"] == LENGTH/4).all()
    assert rows["SPL_dB(0)"] == pytest.approx(level, abs=0.03)
    assert rows["pAmp1_Pa(0)"] == pytest.approx(AMPLITUDE, rel=2e-3)
    assert rows["pAmp1_Pa(2)"] == pytest.approx(AMPLITUDE*np.sqrt(0.5), rel=2e-3)
    assert max(rows["pAmp1_Pa(1)"]) < 5e-3*AMPLITUDE
    assert rows["UAmp1_m_per_s(1)"] == pytest.approx(u0, rel=3e-3)
    assert rows["UAmp1_m_per_s(2)"] == pytest.approx(u0*np.sqrt(0.5), rel=3e-3)

    # p is a cosine; it falls behind by 0.1 % of a period per period
    assert rows["pPhase_rad(0)"][0] == pytest.approx(np.pi/2, abs=8e-3)

    # The loudest cell is at a wall
    assert min(rows["SPL_dB"] - rows["SPL_dB(0)"]) > -0.03
    assert set(np.round(rows["x_m"]/LENGTH, 2)) <= {0.02, 0.98}
    assert min(rows["SWR"]) > 300
    assert max(rows["pAmp2_Pa"]) < 2e-3*AMPLITUDE


def test_finds_the_level_of_the_wave(tube):
    rows = table(tube)
    print({name: column[0] for name, column in rows.items()})
    check(rows)


def test_writes_fields(tube):
    time = max(
        (d for d in tube.path.iterdir() if re.match("0[.]0", d.name)),
        key=lambda d: float(d.name),
    )

    def cells(name):
        text = (time/name).read_text()
        return np.array(
            text.split("(", 1)[1].split(")", 1)[0].split(), dtype=float
        )

    x = (np.arange(25) + 0.5)*LENGTH/25
    exact = AMPLITUDE*abs(np.cos(np.pi*x/LENGTH))
    assert cells("pAmp1") == pytest.approx(exact, abs=3e-3*AMPLITUDE)
    assert cells("SPL") == pytest.approx(
        20*np.log10(cells("pRms")/20e-6), abs=1e-6
    )
    for name in ("pMean", "pPhase", "UAmp1", "UMean", "UCos1", "USin2"):
        assert (time/name).exists(), name


@pytest.mark.parametrize("command, message", [
    # A level needs the steps of a run; other function objects go on
    (("acousticDEMFoam", "-postProcess"), "times that are read are"),
    (("acousticDEMFoam", "-postProcess", "-latestTime"), "no whole period"),
    (("postProcess",), "-fields '(p U)'"),
    (("postProcess", "-fields", "(p U)"), "times that are read are"),
    (("acousticDEMFoam", "-postProcess", "-func", "mag(U)"), ""),
    (("acousticDEMFoam", "-dry-run"), ""),
])
def test_what_cannot_be_done_afterwards_says_so(tmp_path, tube, command, message):
    case = FoamCase.__new__(FoamCase)
    case.path = tmp_path/"case"
    shutil.copytree(tube.path, case.path, ignore=shutil.ignore_patterns("log.*"))
    before = (case.path/FOLDER/"soundPressureLevel.csv").read_bytes()

    log = " ".join(case.run(*command).split())
    assert message in log and "FATAL" not in log
    assert log.count("soundPressureLevel level has no") == (1 if message else 0)
    assert "there are later times already" not in log
    assert log.endswith("End")

    assert (case.path/FOLDER/"soundPressureLevel.csv").read_bytes() == before
    assert len(list((case.path/FOLDER).iterdir())) == 2
    if "mag(U)" in command:
        assert (case.path/times_of(case)[-1]/"mag(U)").is_file()


def times_of(case):
    return sorted(
        (p.name for p in case.path.glob("[0-9]*") if p.name != "0.orig"), key=float
    )


def test_takes_any_step(tmp_path, tube):
    other = run(tmp_path/"case", steps="187.3")
    check(table(other))


def test_serves_stock_solvers(tmp_path, tube):
    other = table(run(tmp_path/"case", "sonicFoam"))
    assert other["SPL_dB(0)"] == pytest.approx(table(tube)["SPL_dB(0)"], abs=1e-3)


def test_does_not_depend_on_the_ranks(tmp_path, tube):
    other = table(run(tmp_path/"case", ranks=2))
    rows = table(tube)
    other["SWR"], rows["SWR"] = 1/other["SWR"], 1/rows["SWR"]
    for name, column in rows.items():
        # The equations are solved to 1e-10 of 1e5 Pa
        assert other[name] == pytest.approx(column, rel=1e-6, abs=1e-5), name
