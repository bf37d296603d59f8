"""Sound between plates loses energy in the layers at the walls.

A standing wave between two plates, one half of the gap, the wall resolved by a
graded mesh. Kirchhoff's attenuation of wide ducts of any cross-section, with
its perimeter P and area A,
    alpha = P/(2 A c) sqrt(nu omega/2) (1 + (gamma - 1)/sqrt(Pr)),
is the first term of the exact solution for long waves (Zwikker and Kosten),
    k^2 = (omega/c)^2 (1 + (gamma - 1) F(sqrt(Pr) H/delta))/(1 - F(H/delta)),
    F(x) = tanh((1 + i) x)/((1 + i) x), with H half of the gap.
"""

import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.append(str(Path(__file__).resolve().parents[1]))
from foamcase import FoamCase, harmonics  # noqa: E402

LENGTH = 0.1226
R = 8314.47/28.96
GAMMA = 1005/(1005 - R)
PRANDTL = 0.71
SOUND_SPEED = np.sqrt(GAMMA*R*293.15)
NU = 1.81e-5/(101325/(R*293.15))
OMEGA = np.pi*SOUND_SPEED/LENGTH
DELTA = np.sqrt(2*NU/OMEGA)
HALF_GAP = 20*DELTA


def kirchhoff(half_gap=HALF_GAP, conducting=True):
    """Loss of amplitude per period, all the same along a wavelength."""
    layers = 1 + conducting*(GAMMA - 1)/np.sqrt(PRANDTL)
    alpha = np.sqrt(NU*OMEGA/2)*layers/(2*half_gap*SOUND_SPEED)
    return alpha*2*LENGTH


def zwikker_kosten():
    """The same exactly, per period without losses; the change of frequency."""
    def mean(x):
        # tanh is one at these widths
        return 1/((1 + 1j)*x)

    omega = complex(OMEGA)
    for _ in range(20):
        x = HALF_GAP*np.sqrt(np.conj(omega)/(2*NU))
        ratio = (1 + (GAMMA - 1)*mean(np.sqrt(PRANDTL)*x))/(1 - mean(x))
        omega = OMEGA/np.sqrt(np.conj(ratio))
    return 2*np.pi*abs(omega.imag)/OMEGA, omega.real/OMEGA - 1


def prepared(
    directory, wall, cells, periods, amplitude=10, steps=100, grading=20,
    half_gap=HALF_GAP
):
    case = FoamCase("standingWaveTube", directory)
    case.replace("constant/acousticProperties", "type +compressible",
                 "type explicitCompressible")
    case.replace("system/setExprFieldsDict", r"28\.28", f"{amplitude}")
    case.replace("system/controlDict", r"(?s)profile\s*\{.*?\}\s*\)",
                 "profile { type none; x (0)")
    case.replace("system/controlDict", "0.0(05|1) 0.005",
                 f"{half_gap/2!r} 0.005")
    case.replace("system/controlDict", "stepsPerPeriod +200",
                 f"stepsPerPeriod {steps}")
    case.replace("system/controlDict", "10.0/", f"{float(periods)}/")

    # 12 cells and a grading of 20: from a quarter of a layer at the wall
    case.replace("system/blockMeshDict", r"(?s)\(\s*\(0       0      0\).*?\);",
                 f"""(
        (0 0 0) ($length 0 0) ($length {half_gap!r} 0) (0 {half_gap!r} 0)
        (0 0 $width) ($length 0 $width)
        ($length {half_gap!r} $width) (0 {half_gap!r} $width)
    );""")
    case.replace("system/blockMeshDict", r"\(25 1 1\) simpleGrading \(1 1 1\)",
                 f"(25 {cells} 1) simpleGrading (1 {grading} 1)")
    case.replace(
        "system/blockMeshDict", r"(?s)sides\s*\{.*?\}",
        """plate { type wall; faces ((0 1 5 4)); }
        middle { type symmetryPlane; faces ((3 7 6 2)); }
        sides { type empty; faces ((0 3 2 1) (4 5 6 7)); }""",
    )
    for field in "pTU":
        case.replace(
            f"0/{field}", r"boundaryField\s*\{",
            f"""boundaryField
            {{
                plate {{ {wall[field]} }}
                middle {{ type symmetryPlane; }}""",
        )

    return case


def loss_and_shift(directory, wall, cells=12, periods=4, steps=100):
    case = prepared(directory, wall, cells, periods, steps=steps)
    case.run("blockMesh")
    case.run("setExprFields")
    case.run("acousticDEMFoam")

    t, p = case.probes("history", "p")
    p = p[:, 0]

    # By the amplitudes of single periods, with the decay and the frequency
    # that were found taken out before
    omega = complex(OMEGA)
    for _ in range(8):
        amplitudes = []
        for i in range(1, periods):
            part = slice(i*steps, (i + 1)*steps)
            swing = np.exp(-1j*omega*t[part])
            columns = [np.ones(steps), swing.real, swing.imag]
            fit = np.linalg.lstsq(np.array(columns).T, p[part], rcond=None)[0]
            amplitudes.append(fit[1] - 1j*fit[2])
        amplitudes = np.array(amplitudes)
        number = np.arange(len(amplitudes))
        decay = np.polyfit(number, np.log(np.abs(amplitudes)), 1)[0]
        drift = np.polyfit(number, np.unwrap(np.angle(amplitudes)), 1)[0]
        omega += 1400*(1j*decay - drift)

    return -2*np.pi*omega.imag/OMEGA, omega.real/OMEGA - 1


STICKS = {
    "U": "type noSlip;",
    "T": "type fixedValue; value uniform 293.15;",
    "p": "type zeroGradient;",
}
SLIPS = {"U": "type slip;", "T": "type zeroGradient;", "p": "type zeroGradient;"}


def test_loses_what_kirchhoff_says(tmp_path):
    loss, shift = loss_and_shift(tmp_path/"case", STICKS)
    exact, detuned = zwikker_kosten()
    print(
        f"loss per period {loss:.5f}: {100*(loss/kirchhoff() - 1):.2f} % off"
        f" Kirchhoff's, {100*(loss/exact - 1):.2f} % off the exact one;"
        f" frequency {shift:.5f}, exact {detuned:.5f}"
    )

    assert loss == pytest.approx(kirchhoff(), rel=0.05)
    assert loss == pytest.approx(exact, rel=0.02)
    assert shift == pytest.approx(detuned, rel=0.03)


def test_loses_nothing_at_walls_that_slip(tmp_path):
    loss, _ = loss_and_shift(tmp_path/"case", SLIPS, cells=4)
    print(f"loss per period {loss:.2e}")

    assert loss < 1e-3*kirchhoff()


def test_is_the_same_on_four_ranks(tmp_path):
    points = " ".join(
        f"({x} {y*HALF_GAP} 0.005)" for x in (0.02, 0.06, 0.1)
        for y in (0.01, 0.1, 0.5, 0.9)
    )
    found = []
    for ranks in (1, 2, 4):
        case = prepared(tmp_path/str(ranks), STICKS, 12, 0.05)
        case.replace("system/controlDict", r"probeLocations\s*\([^;]*\);",
                     f"probeLocations ({points});")
        case.run("blockMesh")
        case.run("setExprFields")
        if ranks == 1:
            case.run("acousticDEMFoam")
        else:
            case.write("system/decomposeParDict", f"""FoamFile
{{
    version 2.0; format ascii; class dictionary; object decomposeParDict;
}}
numberOfSubdomains {ranks};
method  simple;
simpleCoeffs {{ n ({ranks//2} 2 1); delta 0.001; }}
""")
            case.run("decomposePar")
            case.run("mpirun", "--oversubscribe", "-np", ranks,
                     "acousticDEMFoam", "-parallel")
        found.append(case.probes("history", "U")[1])

    largest = np.abs(found[0]).max()
    for other in found[1:]:
        difference = np.abs(other - found[0]).max()/largest
        print(f"difference {difference:.1e} of the largest velocity")
        assert difference < 1e-10


def long_wave_streaming(y, half_gap):
    """Mean flow over Rayleigh's edge velocity; y from the middle.

    The mean of the momentum equation along the plates, to second order in the
    amplitude, with the linear wave h(y) = 1 - cosh(K y)/cosh(K H), for gaps
    of any width that are narrow against the wavelength. No net flow.
    """
    grid = np.linspace(0, half_gap, 4000)

    def integral(f):
        return np.concatenate(
            [[0], np.cumsum(0.5*(f[1:] + f[:-1])*np.diff(grid))]
        )

    def flow(stress):
        """Velocity with that mean stress over the density, none at the wall"""
        slope = integral(stress)
        return (slope - slope[-1])/NU

    K = (1 - 1j)/DELTA
    h = 1 - (
        np.exp(K*(grid - half_gap))*(1 + np.exp(-2*K*grid))
        / (1 + np.exp(-2*K*half_gap))
    )
    mean = integral(h)[-1]/half_gap

    # Over U dU/dx: the stresses <u u> along and <u v> across, and the mass that
    # the wave carries
    stress = integral(abs(h)**2) - 0.5*np.real(h*np.conj(integral(h - mean)))
    drift = 0.5*np.real(mean*np.conj(h)/(1j*OMEGA))

    driven, pushed = flow(stress), flow(grid)
    pressure = (
        -(integral(driven)[-1] + integral(drift)[-1])/integral(pushed)[-1]
    )
    return np.interp(y, grid, (driven + pressure*pushed)*OMEGA/2/(-3/8))


@pytest.mark.full
def test_streams_as_rayleigh_says(tmp_path):
    """The layer drives a mean flow, 3 u_0^2/(8 c) sin(2 k x) at its edge.

    Outside of it the flow between plates far apart is that times
    (3 (y/H)^2 - 1)/2, with y from the middle; 6 % less at 30 layers. Walls
    without conduction: with it there is 13 % more (Rott). A piston at the
    resonance makes up for the losses.
    """
    periods, steps, cells, grading = 60, 100, 28, 14
    pressure = 400
    half_gap = 30*DELTA
    walls = dict(STICKS, T="type zeroGradient;")
    case = prepared(
        tmp_path/"case", walls, cells, periods, pressure, steps, grading,
        half_gap
    )

    loss = kirchhoff(half_gap, conducting=False)
    frequency = OMEGA/(2*np.pi)*(1 - loss/(2*np.pi))
    density = 101325/(R*293.15)
    speed = pressure/(density*SOUND_SPEED)*loss/2
    case.replace("0/U", r"left\s*\{[^}]*\}", f"""left
    {{
        type            acousticPiston;
        velocityAmplitude {speed!r};
        frequency       {frequency!r};
        phase           {np.pi/2!r};
    }}""")
    case.replace("system/controlDict", "frequency +1400",
                 f"frequency {frequency!r}")

    # Two columns of cells near a quarter and three quarters of the tube, where
    # sin(2 k x) = 1 and -1: what the piston pumps is much the same in both
    growth = grading**(1/(cells - 1))
    edges = np.concatenate([[0], np.cumsum(growth**np.arange(cells))])
    edges *= half_gap/edges[-1]
    centres = 0.5*(edges[1:] + edges[:-1])
    x = 6.5*LENGTH/25
    points = " ".join(
        f"({place!r} {y!r} 0.005)" for place in (x, LENGTH - x)
        for y in centres
    )
    case.replace("system/controlDict", r"probeLocations\s*\([^;]*\);",
                 f"probeLocations ({points});")

    case.run("blockMesh")
    case.run("setExprFields")
    case.run("acousticDEMFoam")

    t, U = case.probes("history", "U")
    last = slice(-5*steps, None)
    u = U[last, ::3]
    swing = harmonics(t[last], u[:, cells - 1], [frequency, 2*frequency])
    u0 = abs(swing[0])/np.sin(np.pi*x/LENGTH)
    mean = u.mean(axis=0)
    mean = 0.5*(mean[:cells] - mean[cells:])

    eta = 1 - centres/half_gap
    outer = centres > 5*DELTA
    shape = np.array([(3*eta**2 - 1)/2, np.ones(cells)]).T[outer]

    rayleigh = -3*u0**2/(8*SOUND_SPEED)*np.sin(2*np.pi*x/LENGTH)
    profile = mean/rayleigh
    exact = long_wave_streaming(half_gap - centres, half_gap)
    edge, expected = (
        np.linalg.lstsq(shape, flow[outer], rcond=None)[0][0]
        for flow in (profile, exact)
    )
    print(
        f"u0 {u0:.3f} m/s, second harmonic {abs(swing[1]/swing[0]):.3f},"
        f" streaming {edge:.3f} of Rayleigh's, long-wave theory {expected:.3f};"
        f" profiles differ by up to {np.abs(profile - exact).max():.3f}"
    )
    assert edge == pytest.approx(1, rel=0.1)
    assert edge == pytest.approx(expected, rel=0.05)
    assert np.abs(profile - exact).max() < 0.05
