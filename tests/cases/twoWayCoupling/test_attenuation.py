"""An aerosol attenuates and slows down sound as Temkin and Dobbins say.

In a closed tube, at rest at first, the fundamental decays: its complex
frequency is compared with the exact one (tutorials/aerosolAttenuation/plot.py),
which is that of the tube with clean gas, computed likewise, changed by the
particles. These stand in a row, at equal distances.
"""

import importlib.util

import numpy as np
import pytest
from aerosolcase import AerosolCase
from foamcase import ROOT

N = 200  # particles, 8 per cell
LENGTH = 0.1226  # m


def load():
    file = ROOT/"tutorials/aerosolAttenuation/plot.py"
    spec = importlib.util.spec_from_file_location("attenuation", file)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def run(
    directory, s, m, steps=200, periods=10, cells=25, drag="Stokes",
    sound="compressible", places=(np.arange(N) + 0.5)/N
):
    """A tube with an aerosol, or without an effect of it if m is 0."""
    case = AerosolCase(directory, ROOT/"tutorials/aerosolAttenuation")
    case.entry("system/tube", "omegaTau", s)
    case.entry("system/tube", "massLoading", m or 0.1)
    case.entry("system/tube", "count", len(places))
    if not m:
        case.entry("system/tube", "coupling", "none")
    d = np.sqrt(18*1.81e-5*s/(2*np.pi*1400*2300))
    case.particles(
        [((x*LENGTH, 5e-3, 5e-3), d) for x in places],
        density="$particleDensity",
    )
    case.model("drag", f"type {drag}; slipCorrection none;")
    case.control("stepsPerPeriod", steps)
    case.control("endTime", f"#eval{{ {periods}.0/$frequency }}")
    case.replace("system/blockMeshDict", r"\(25 1 1\)", f"({cells} 1 1)")
    case.replace(
        "constant/acousticProperties", r"type\s+compressible;",
        f"type {sound};"
    )
    case.run("blockMesh")
    case.run("setExprFields")
    case.run("acousticDEMFoam")
    return case


@pytest.fixture(scope="module", name="clean")
def fixture_clean(tmp_path_factory):
    """Frequency without aerosol, by sound, steps per period and cells."""
    known = {}

    def frequency(*key):
        sound, steps, cells = key
        if key not in known:
            case = run(
                tmp_path_factory.mktemp("clean")/"case", 1, 0, steps,
                cells=cells, sound=sound,
            )
            known[key] = load().analyse(case.path)
        return known[key]

    return frequency


SOUNDS = ("compressible", "explicitCompressible")
SOME = [
    ("compressible", 0.1, 0.01, 200, 25), ("compressible", 0.1, 0.3, 200, 25),
    ("compressible", 1, 0.1, 200, 25), ("compressible", 10, 0.01, 200, 25),
    ("compressible", 10, 0.3, 200, 25), ("compressible", 0.3, 0.3, 100, 25),
    ("explicitCompressible", 0.1, 0.3, 100, 25),
    ("explicitCompressible", 1, 0.1, 100, 25),
    ("explicitCompressible", 10, 0.01, 100, 25),
]
ALL = [
    (sound, s, m, steps, 25)
    for sound in SOUNDS
    for s in (0.1, 0.3, 1, 3, 10) for m in (0.01, 0.1, 0.3)
    for steps in (100, 200)
] + [("compressible", 1, 0.3, 200, 50), ("compressible", 0.1, 0.3, 400, 50)]


@pytest.mark.parametrize(
    "sound, s, m, steps, cells",
    SOME + [
        pytest.param(*one, marks=pytest.mark.full)
        for one in ALL if one not in SOME
    ],
)
def test_is_that_of_Temkin_and_Dobbins(
    tmp_path, clean, full, sound, s, m, steps, cells
):
    w0 = clean(sound, steps, cells)
    case = run(
        tmp_path/"case", s, m, steps, 20 if full else 10, cells, sound=sound
    )
    w, exact = load().analyse(case.path, w0)

    damping = (w.imag - w0.imag)/(exact.imag - w0.imag) - 1
    dispersion = (w.real - w0.real)/(exact.real - w0.real) - 1
    print(
        f"\n{sound}, omega tau {s:g}, loading {m:g}, T/{steps}, {2*cells} cells per"
        f" wavelength: attenuation {100*damping:+.2f} %, change of frequency"
        f" {100*dispersion:+.2f} %"
    )
    assert abs(damping) < 0.02
    assert abs(dispersion) < 0.02


def error(clean, directory, steps, cells, **more):
    """Of attenuation and change of frequency, at omega tau = 1."""
    w0 = clean("compressible", steps, cells)
    case = run(directory, 1, 0.1, steps, cells=cells, **more)
    w, exact = load().analyse(case.path, w0)
    return np.array([
        (w.imag - w0.imag)/(exact.imag - w0.imag) - 1,
        (w.real - w0.real)/(exact.real - w0.real) - 1,
    ])


def test_error_is_of_second_order(tmp_path, clean):
    """Of the cells and of the steps: the coupling adds no lag to the sound."""
    coarse = error(clean, tmp_path/"coarse", 100, 12)
    fine = error(clean, tmp_path/"fine", 200, 24)
    print(f"errors {coarse} and, with half the cells and steps, {fine}")
    assert coarse/fine == pytest.approx([4, 4], abs=0.4)


def test_particles_count_where_the_gas_moves(tmp_path, clean):
    """With more of them in the middle the wave feels more than their mass."""
    dense = 0.2
    x = np.linspace(0, 1, 1001)
    share = x - dense*np.sin(2*np.pi*x)/(2*np.pi)
    places = np.interp((np.arange(5*N) + 0.5)/(5*N), share, x)

    even = error(clean, tmp_path/"even", 100, 24)
    uneven = error(clean, tmp_path/"uneven", 100, 24, places=places)
    loading = load().loading(tmp_path/"uneven")
    print(f"loading {loading:.4f}: errors {uneven}, of an even one {even}")
    assert loading == pytest.approx(0.1*(1 + dense/2), rel=1e-4)
    assert uneven == pytest.approx(even, abs=0.001)


def test_linear_theory_of_small_loadings():
    """The exact frequency has the published limits."""
    w0, m = 2*np.pi*1400, 1e-6
    for s in (0.1, 1, 10):
        w, _ = load().frequencies(w0, m, s/w0)
        # Per time: c times the attenuation per length, w m s/(1 + s^2)/2
        assert -w.imag == pytest.approx(w0/2*m*s/(1 + s*s), rel=1e-4)
        assert (w0/w.real)**2 - 1 == pytest.approx(m/(1 + s*s), rel=1e-3)
