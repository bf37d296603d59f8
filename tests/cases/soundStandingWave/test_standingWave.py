"""A closed tube keeps its sound: amplitude and frequency of the fundamental.

The amplitude is 10 Pa, so small that steepening does not count. What is left
is known: the time scheme loses 390/m^3 of the amplitude per period at m steps
per period, viscosity and heat conduction a little more, and the frequency is
low by (kh)^2/24 + (omega dt)^2/3.

The explicit scheme is of fourth order for such a wave: the frequency is low by
(kh)^4/30 and (omega dt)^4/120.
"""

import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.append(str(Path(__file__).resolve().parents[1]))
from foamcase import FoamCase, harmonics  # noqa: E402

LENGTH = 0.1226
SOUND_SPEED = np.sqrt(1005/(1005 - 8314.47/28.96)*8314.47/28.96*293.15)
FUNDAMENTAL = SOUND_SPEED/(2*LENGTH)

# Classical absorption in the bulk, per wavelength: the walls slip
DENSITY = 101325/(8314.47/28.96*293.15)
ABSORPTION = (
    2*np.pi**2*FUNDAMENTAL/(DENSITY*SOUND_SPEED**2)
    * 1.81e-5*(4/3 + 0.4/0.71)
)


def expected_loss(steps):
    return 4*np.pi**4/steps**3 + ABSORPTION


def expected_shift(cells, steps):
    return -((2*np.pi/cells)**2/24 + (2*np.pi/steps)**2/3)


def loss_and_shift(
    directory, steps=200, cells=25, periods=12, kind="compressible",
    prepare=None
):
    """Loss of amplitude per period, and relative error of the frequency."""
    case = FoamCase("standingWaveTube", directory)
    case.replace("constant/acousticProperties", "type +compressible",
                 f"type {kind}")
    case.replace("system/setExprFieldsDict", r"28\.28", "10")
    case.replace(
        "system/controlDict", "stepsPerPeriod +200", f"stepsPerPeriod {steps}"
    )
    case.replace("system/controlDict", "10.0/", f"{periods}.0/")
    case.replace("system/blockMeshDict", r"\(25 1 1\)", f"({cells} 1 1)")
    if prepare:
        prepare(case)

    case.run("blockMesh")
    case.run("setExprFields")
    case.run("acousticDEMFoam")

    t, p = case.probes("history", "p")

    # The first period starts with one step of first order
    amplitudes = []
    for i in range(1, periods):
        part = slice(i*steps, (i + 1)*steps)
        amplitudes.append(
            harmonics(t[part], p[part, 0], [FUNDAMENTAL, 2*FUNDAMENTAL])[0]
        )
    amplitudes = np.array(amplitudes)
    number = np.arange(len(amplitudes))

    decay = np.polyfit(number, np.log(np.abs(amplitudes)), 1)[0]
    drift = np.polyfit(number, np.unwrap(np.angle(amplitudes)), 1)[0]

    # y = Re(a exp(-i omega t)): a phase that falls is a lower frequency
    return -decay, -drift*1400/(2*np.pi*FUNDAMENTAL)


def test_loses_and_detunes_as_little_as_the_scheme_promises(tmp_path):
    loss, shift = loss_and_shift(tmp_path/"case")
    print(f"loss per period {100*loss:.4f} %, frequency {100*shift:.3f} %")

    assert 0 < loss < 1e-4
    assert loss == pytest.approx(expected_loss(200), rel=0.15)
    assert abs(shift) < 1.5e-3
    assert shift == pytest.approx(expected_shift(50, 200), rel=0.05)


def test_converges_in_time_and_space(tmp_path):
    coarse, _ = loss_and_shift(tmp_path/"m100", steps=100)
    fine, shift = loss_and_shift(tmp_path/"fine", cells=50, steps=200)
    print(f"m = 100: {100*coarse:.4f} %; 100 cells: {100*fine:.4f} %, {shift}")

    assert coarse == pytest.approx(expected_loss(100), rel=0.15)
    assert fine == pytest.approx(expected_loss(200), rel=0.15)
    assert shift == pytest.approx(expected_shift(100, 200), rel=0.05)


def test_keeps_it_for_a_hundred_periods_explicitly(tmp_path):
    loss, shift = loss_and_shift(
        tmp_path/"case", steps=100, periods=100, kind="explicitCompressible"
    )
    numerical = 100*(loss - ABSORPTION)
    print(f"100 periods: amplitude {-100*numerical:.4f} % beside absorption of "
          f"{10000*ABSORPTION:.4f} %, frequency {100*shift:.5f} %")

    assert abs(numerical) < 1e-3
    assert abs(shift) < 5e-4
    assert shift == pytest.approx(-(2*np.pi/50)**4/30, rel=0.05)


def wedge(case):
    """The tube as a wedge, with prisms at the axis."""
    radius, angle = 0.02, np.radians(2.5)
    y, z = radius*np.cos(angle), radius*np.sin(angle)
    case.replace(
        "system/blockMeshDict", r"(?s)vertices\s*\(.*?\n\);",
        f"""vertices
        (
            (0 0 0) ($length 0 0) ($length {y} {-z}) (0 {y} {-z})
            ($length {y} {z}) (0 {y} {z})
        );""",
    )
    case.replace("system/blockMeshDict", r"hex \(0 1 2 3 4 5 6 7\) \(25 1 1\)",
                 "hex (0 1 2 3 0 1 4 5) (25 6 1)")
    case.replace(
        "system/blockMeshDict", r"(?s)boundary\s*\(.*",
        """boundary
        (
            left { type wall; faces ((0 3 5 0)); }
            right { type wall; faces ((1 2 4 1)); }
            wall { type wall; faces ((2 3 5 4)); }
            front { type wedge; faces ((0 1 2 3)); }
            back { type wedge; faces ((0 1 4 5)); }
        );""",
    )
    for field, wall in (
        ("U", "slip"), ("p", "zeroGradient"), ("T", "zeroGradient")
    ):
        case.replace(
            f"0/{field}", r"(?s)sides\s*\{.*?\}",
            f"""wall {{ type {wall}; }}
            "front|back" {{ type wedge; }}
            defaultFaces {{ type empty; }}""",
        )
    case.replace("system/controlDict", "0.005 0.005", "0.005 0")


def test_keeps_it_in_a_wedge_explicitly(tmp_path):
    loss, shift = loss_and_shift(
        tmp_path/"case", steps=100, kind="explicitCompressible", prepare=wedge
    )
    print(f"wedge: loss {loss - ABSORPTION:.2e}, frequency {shift:.2e}")

    assert abs(loss - ABSORPTION) < 1e-5
    assert abs(shift) < 5e-4


def test_converges_explicitly(tmp_path):
    errors = []
    for cells, steps in ((10, 40), (20, 80), (40, 160)):
        loss, shift = loss_and_shift(
            tmp_path/str(cells), steps, cells, kind="explicitCompressible"
        )
        errors.append((loss - ABSORPTION, shift))
        print(f"{2*cells} cells, {steps} steps: loss {loss - ABSORPTION:.3e}, "
              f"frequency {shift:.3e}")

    orders = np.log2(
        [errors[0][1]/errors[1][1], errors[1][1]/errors[2][1]]
    )
    print("orders of the frequency", orders)
    assert min(orders) > 3.8


@pytest.mark.parametrize(
    "file, pattern, text, warning",
    [
        ("fvSchemes", "backward 1", "Euler", "Euler loses about 9.8"),
        ("fvSchemes", "backward 1", "backward", "without the coefficient 1"),
        ("fvSolution", "Correctors +2", "Correctors 1", "makes sound grow"),
    ],
)
def test_warns_of_settings_that_do_not_keep_sound(
    tmp_path, file, pattern, text, warning
):
    case = FoamCase("standingWaveTube", tmp_path/"case")
    case.replace(f"system/{file}", pattern, text)
    case.replace("system/controlDict", "10.0/", "0.02/")
    case.run("blockMesh")

    log = " ".join(case.run("acousticDEMFoam").split())
    assert log.count(warning) == 1


def test_refuses_the_enthalpy_form(tmp_path):
    case = FoamCase("standingWaveTube", tmp_path/"case")
    case.replace(
        "constant/thermophysicalProperties",
        "sensibleInternalEnergy",
        "sensibleEnthalpy",
    )
    case.run("blockMesh")

    with pytest.raises(AssertionError, match="sensibleInternalEnergy"):
        case.run("acousticDEMFoam")


@pytest.mark.parametrize(
    "file, pattern, text, message",
    [
        ("turbulenceProperties", "laminar", "RAS", "laminar flow only"),
        ("acousticProperties", "SPL ", "logSolvers yes; SPL ", "logSolvers"),
        ("acousticProperties", "SPL ", "force push; SPL ", "push"),
    ],
)
def test_refuses_what_the_explicit_sound_does_not_know(
    tmp_path, file, pattern, text, message
):
    case = FoamCase("standingWaveTube", tmp_path/"case")
    case.replace("constant/acousticProperties", "type +compressible",
                 "type explicitCompressible")
    case.replace(f"constant/{file}", pattern, text)
    case.run("blockMesh")

    with pytest.raises(AssertionError, match=message):
        case.run("acousticDEMFoam")


def test_warns_of_coarse_cells_and_divides_steps_explicitly(tmp_path):
    case = FoamCase("standingWaveTube", tmp_path/"case")
    case.replace("constant/acousticProperties", "type +compressible",
                 "type explicitCompressible")
    case.replace("system/blockMeshDict", r"\(25 1 1\)", "(8 1 1)")
    case.replace("system/controlDict", "stepsPerPeriod +200",
                 "stepsPerPeriod 10")
    case.replace("system/controlDict", "10.0/", "0.2/")
    case.run("blockMesh")
    log = case.run("acousticDEMFoam")

    # c T/10 are 1.6 of 16 cells per wavelength: two parts of 0.8
    assert "frequency that is 0.079" in log
    assert "2 parts per fluid step, acoustic Courant number 0.7999" in log
    assert log.count("Courant") == 1
