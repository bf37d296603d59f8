"""A piston in a closed tube: the level that it makes, off resonance.

With a piston at x = 0 and a rigid wall at x = L the steady state is
p(x) = rho c u_p cos(k(L - x))/sin(kL), without losses. A smooth ramp leaves
the resonances asleep; what they say nevertheless is fitted beside.
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


def driven(
    directory, frequency, piston, cells=25, periods=25, kind="compressible"
):
    """Amplitudes of the pressure at the cells nearest to both ends."""
    case = FoamCase("standingWaveTube", directory)
    case.replace("constant/acousticProperties", "type +compressible",
                 f"type {kind}")
    case.replace(
        "system/controlDict", "frequency +1400", f"frequency {frequency}"
    )
    case.replace("system/controlDict", "10.0/", f"{periods}.0/")
    case.replace("system/controlDict", "0.0613", "0.1216")
    case.replace("system/blockMeshDict", r"\(25 1 1\)", f"({cells} 1 1)")
    case.replace(
        "constant/acousticProperties", "frequency +1400",
        f"frequency {frequency}",
    )
    case.replace(
        "0/U", r"left\s*\{[^}]*\}",
        f"""left
    {{
        type            acousticPiston;
        {piston}
        rampPeriods     15;
    }}""",
    )

    case.run("blockMesh")
    case.run("acousticDEMFoam")

    t, p = case.probes("history", "p")
    steady = t > 18/frequency
    resonances = [
        n*SOUND_SPEED/(2*LENGTH)*(1 - 1e-3) for n in (1, 2)
    ]
    return [
        harmonics(t[steady], p[steady, i], [frequency] + resonances)[0]
        for i in range(2)
    ]


def exact(frequency, x):
    k = 2*np.pi*frequency/SOUND_SPEED
    return (
        DENSITY*SOUND_SPEED*PISTON*np.cos(k*(LENGTH - x))/np.sin(k*LENGTH)
    )


@pytest.mark.parametrize(
    "kind, frequency, most",
    [
        ("compressible", 700, 0.01),
        ("compressible", 1000, 0.01),
        ("explicitCompressible", 700, 0.002),
        ("explicitCompressible", 1000, 0.002),
    ],
)
def test_makes_the_level_of_the_exact_solution(
    tmp_path, kind, frequency, most
):
    piston, wall = driven(
        tmp_path/"case", frequency,
        f"velocityAmplitude {PISTON}; frequency {frequency};", kind=kind,
    )

    half = 0.5*LENGTH/25
    error = abs(wall)/abs(exact(frequency, LENGTH - half)) - 1
    print(f"{frequency} Hz: level at the wall {100*error:.2f} % off")
    assert abs(error) < most

    error = abs(abs(piston) - abs(exact(frequency, half)))
    print(f"{frequency} Hz: at the piston {error} of {abs(wall)} Pa off")
    assert error < 3*most*abs(wall)

    # Pressure and velocity of the piston, v = sin, are out of phase
    assert abs(wall.imag) < most*abs(wall)


def test_understands_displacement_and_tables(tmp_path):
    frequency = 1000
    displacement = PISTON/(2*np.pi*frequency)
    _, wall = driven(
        tmp_path/"case", frequency,
        f"""displacementAmplitude table
            ((0 {displacement}) (1 {displacement}));
        frequency       constant {frequency};
        direction       (1 0 0);""",
    )

    assert abs(wall) == pytest.approx(
        abs(exact(frequency, LENGTH - 0.5*LENGTH/25)), rel=0.01
    )
