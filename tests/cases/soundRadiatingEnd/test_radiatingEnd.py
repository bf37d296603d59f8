"""A tube that radiates at one end: waves leave, and hardly any come back.

waveTransmissive is of first order in the cell size; for the velocity it does
better than zeroGradient. explicitCompressible takes it for the characteristic
of a wave that leaves.
"""

import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.append(str(Path(__file__).resolve().parents[1]))
from foamcase import FoamCase, harmonics  # noqa: E402

LENGTH = 0.1226
SOUND_SPEED = np.sqrt(1005/(1005 - 8314.47/28.96)*8314.47/28.96*293.15)
DENSITY = 101325/(8314.47/28.96*293.15)
PISTON = 0.02  # m/s


@pytest.mark.parametrize(
    "kind, velocity, most",
    [
        (
            "compressible",
            "type waveTransmissive; psi thermo:psi; gamma 1.4;"
            " value uniform (0 0 0);",
            0.03,
        ),
        ("compressible", "type zeroGradient;", 0.07),
        ("explicitCompressible", "type zeroGradient;", 0.003),
    ],
)
def test_hardly_reflects(tmp_path, kind, velocity, most):
    case = FoamCase("standingWaveTube", tmp_path/"case")
    case.replace("constant/acousticProperties", "type +compressible",
                 f"type {kind}")

    case.replace(
        "0/U", r"left\s*\{[^}]*\}",
        f"""left
    {{
        type            acousticPiston;
        velocityAmplitude {PISTON};
        frequency       1400;
        rampPeriods     3;
    }}""",
    )
    case.replace(
        "0/U", r"right\s*\{[^}]*\}",
        f"right {{ {velocity} }}",
    )
    case.replace(
        "0/p", r"right\s*\{[^}]*\}",
        """right
    {
        type            waveTransmissive;
        psi             thermo:psi;
        gamma           1.4;
        fieldInf        101325;
        lInf            10;
        value           uniform 101325;
    }""",
    )
    centres = (np.arange(25) + 0.5)*LENGTH/25
    case.replace(
        "system/controlDict", r"probeLocations\s*\([^;]*\);",
        "probeLocations ("
        + " ".join(f"({x} 0.005 0.005)" for x in centres) + ");",
    )

    case.run("blockMesh")
    case.run("acousticDEMFoam")

    # p(x) = forward exp(ikx) + backward exp(-ikx)
    t, p = case.probes("history", "p")
    steady = t > 6/1400
    amplitudes = np.array(
        [harmonics(t[steady], row[steady], [1400, 2800])[0] for row in p.T]
    )
    k = 2*np.pi*1400/SOUND_SPEED
    waves = np.array([np.exp(1j*k*centres), np.exp(-1j*k*centres)]).T
    forward, backward = np.linalg.lstsq(waves, amplitudes, rcond=None)[0]

    reflection = abs(backward)/abs(forward)
    level = abs(forward)/(DENSITY*SOUND_SPEED*PISTON)
    ratio = abs(amplitudes).max()/abs(amplitudes).min()
    print(
        f"reflection {100*reflection:.2f} %, standing-wave ratio {ratio:.4f},"
        f" level {100*(level - 1):.2f} % off, mean {p[steady].mean() - 101325}"
    )

    assert reflection < most
    assert ratio < (1 + most)/(1 - most)
    assert level == pytest.approx(1, rel=0.02)
