"""A loud wave steepens into a sawtooth, which then loses energy in its shock.

A plane wave that travels round a periodic piece of one wavelength, a simple
wave of the equations of gas dynamics. Before the shock forms, at sigma = 1, its
harmonics are those of Fubini, 2 J_n(n sigma)/(n sigma); from sigma = 3 on those
of weak-shock theory, 2/(n (1 + sigma)), the limit of Fay's solution for small
viscosity. sigma = beta k u_0 t with beta = (gamma + 1)/2.
"""

import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.append(str(Path(__file__).resolve().parents[1]))
from foamcase import FoamCase  # noqa: E402

LENGTH = 0.2452
R = 8314.47/28.96
GAMMA = 1005/(1005 - R)
T0 = 293.15
SOUND_SPEED = np.sqrt(GAMMA*R*T0)
DENSITY = 101325/(R*T0)
FREQUENCY = SOUND_SPEED/LENGTH


def bessel(n, x):
    angle = np.linspace(0, np.pi, 2001)
    return np.trapz(np.cos(n*angle - x*np.sin(angle)), angle)/np.pi


def harmonics(directory, level, sigmas, cells, steps=100):
    """Amplitudes of u over u_0 for the first four harmonics, by sigma."""
    amplitude = np.sqrt(2)*20e-6*10**(level/20)/(DENSITY*SOUND_SPEED)
    strength = (GAMMA + 1)/2*2*np.pi*FREQUENCY/SOUND_SPEED*amplitude

    case = FoamCase("standingWaveTube", directory)
    case.replace("constant/acousticProperties", "type +compressible",
                 "type explicitCompressible")
    case.replace("system/blockMeshDict", "length +0.1226", f"length {LENGTH}")
    case.replace("system/blockMeshDict", r"\(25 1 1\)", f"({cells} 1 1)")
    for side, other in (("left", "right"), ("right", "left")):
        case.replace(
            "system/blockMeshDict", rf"{side}\s*\{{\s*type +wall;",
            f"{side}\n{{\ntype cyclic; neighbourPatch {other};",
        )
        for field in "pTU":
            case.replace(f"0/{field}", rf"{side}\s*\{{[^}}]*\}}",
                         f"{side} {{ type cyclic; }}")

    # A simple wave: c - (gamma - 1)/2 u is the same everywhere
    speed = f"({amplitude!r}*sin({2*np.pi/LENGTH!r}*pos().x()))"
    ratio = f"(1 + {(GAMMA - 1)/2/SOUND_SPEED!r}*{speed})"
    case.write("system/setExprFieldsDict", f"""FoamFile
{{
    version 2.0; format ascii; class dictionary; object setExprFieldsDict;
}}
expressions
(
    velocity
    {{
        field U; dimensions [0 1 -1 0 0 0 0];
        expression "vector({speed}, 0, 0)";
    }}
    pressure
    {{
        field p; dimensions [1 -1 -2 0 0 0 0];
        expression "101325*pow({ratio}, {2*GAMMA/(GAMMA - 1)!r})";
    }}
    temperature
    {{
        field T; dimensions [0 0 0 1 0 0 0];
        expression "{T0}*sqr({ratio})";
    }}
);
""")
    step = 1/(FREQUENCY*steps)
    centres = (np.arange(cells) + 0.5)*LENGTH/cells
    points = " ".join(f"({x!r} 0.005 0.005)" for x in centres)
    case.replace("system/controlDict", r"probeLocations\s*\([^;]*\);",
                 f"probeLocations ({points});")
    case.replace("system/controlDict", r"fields +\(p U\);\s*probe",
                 "fields (p T U); probe")
    case.replace("system/controlDict", r"(?s)profile\s*\{.*?\}\s*\)",
                 "profile { type none; x (0)")
    case.replace("system/controlDict", r"(?m)^deltaT .*$", f"deltaT {step!r};")
    case.replace("system/controlDict", r"(?m)^endTime .*$",
                 f"endTime {max(sigmas)/strength + step!r};")
    case.run("blockMesh")
    case.run("setExprFields")
    case.run("acousticDEMFoam")

    t, u = case.probes("history", "U")
    _, p = case.probes("history", "p")
    _, T = case.probes("history", "T")
    rho = p/(R*T)
    print(f"lowest pressure {p.min():.0f} Pa, density {rho.min():.4f}, "
          f"mass drift {np.ptp(rho.mean(axis=1))/rho.mean():.1e}")
    assert p.min() > 0 and rho.min() > 0

    spectrum = 2*np.abs(np.fft.rfft(u[:, ::3], axis=1))/cells/amplitude
    return {
        s: spectrum[np.argmin(abs(t - s/strength)), 1:5] for s in sigmas
    }


def fubini(sigma):
    return [2*bessel(n, n*sigma)/(n*sigma) for n in range(1, 5)]


def sawtooth(sigma):
    return [2/(n*(1 + sigma)) for n in range(1, 5)]


def compare(found, theory, first, second):
    for sigma, amplitudes in found.items():
        expected = theory(sigma)
        print(f"sigma {sigma}:", amplitudes, "theory", np.array(expected))
        assert amplitudes[0] == pytest.approx(expected[0], rel=first)
        assert amplitudes[1] == pytest.approx(expected[1], rel=second)


@pytest.mark.parametrize("level, cells", [(149, 100), (165, 50)])
def test_grows_the_harmonics_of_fubini(tmp_path, level, cells):
    found = harmonics(tmp_path/"case", level, [0.25, 0.5, 0.7], cells)

    # Fubini leaves out the next order in the Mach number, 0.0055 and 0.035
    compare(found, fubini, 0.002, 0.01)


def test_loses_energy_in_a_shock_of_165_dB(tmp_path):
    found = harmonics(tmp_path/"case", 165, [3, 4, 6], cells=100)

    # The shock is some cells thick, which delays the sawtooth by as much of
    # the wavelength
    compare(found, sawtooth, 0.02, 0.04)


@pytest.mark.full
def test_loses_energy_in_a_shock_of_149_dB(tmp_path):
    found = harmonics(tmp_path/"case", 149, [3], cells=200, steps=200)

    compare(found, sawtooth, 0.02, 0.04)
