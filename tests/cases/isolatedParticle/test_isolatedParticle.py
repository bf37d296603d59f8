"""Single particles follow the sound as theory says: entrainment and lag."""

import importlib.util
from pathlib import Path

import numpy as np
import pytest
from foamcase import ROOT, FoamCase, harmonics

LENGTH = 0.1226
SOUND_SPEED = np.sqrt(1005/(1005 - 8314.47/28.96)*8314.47/28.96*293.15)


def load(file):
    """The tutorial's own script, as a module."""
    spec = importlib.util.spec_from_file_location("plot", file)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module", name="theory")
def fixture_theory():
    return load(ROOT/"tutorials/isolatedParticle/plot.py")


def test_analytic_sound(tmp_path):
    case = FoamCase("isolatedParticle", tmp_path/"case")
    case.run("blockMesh")
    case.run("acousticDEMFoam")

    # The tutorial's script, for its own case: table and picture
    script = load(case.path/"plot.py")
    t, diameters, v = script.read(case.path)
    assert len(t) == 75
    assert list(diameters) == [1e-6, 2e-6, 5e-6, 10e-6, 20e-6]

    for d, u in zip(diameters, v.T/script.U0):
        eta, phi = script.fit(t, u, d)
        print(
            f"{1e6*d:g} um: entrainment {eta/script.entrainment(d) - 1:.1e},"
            f" lag {phi - script.phase(d):.1e} rad off"
        )
        assert eta == pytest.approx(script.entrainment(d), rel=1e-3)
        assert phi == pytest.approx(script.phase(d), rel=1e-3)

        # At every time, the transient included
        assert np.abs(u - script.velocity(d, t)).max() < 1e-3

    script.main()
    assert (case.path/"isolatedParticle.png").stat().st_size > 10000


def test_solved_sound(tmp_path, theory):
    """The same in a tube that holds its fundamental, 120 dB."""
    case = FoamCase("standingWaveTube", tmp_path/"case")
    tutorial = Path(ROOT/"tutorials/isolatedParticle")
    case.write(
        "constant/aerosolProperties",
        (tutorial/"constant/aerosolProperties").read_text(),
    )
    case.replace("system/controlDict", "10.0/", "3.0/")
    case.replace(
        "system/controlDict", "writeInterval +.stepsPerPeriod",
        "writeInterval 8",
    )
    case.run("blockMesh")
    case.run("setExprFields")
    case.run("acousticDEMFoam")

    # The gas at the particles, its frequency as low as the cells make it
    shift = (2*np.pi/50)**2/24 + (2*np.pi/200)**2/3
    frequency = SOUND_SPEED/(2*LENGTH)*(1 - shift)
    times, u = case.probes("history", "U")
    gas = harmonics(times, u[:, 3], [frequency, 2*frequency])[0]

    # y = Re(a exp(-i omega t)); a pure sine is a = i
    amplitude, lag = abs(gas), np.angle(gas/1j)
    t, diameters, v = theory.read(case.path)
    print(f"gas {amplitude} m/s, {lag} rad")
    assert amplitude == pytest.approx(28.28/(1.204*343.2), rel=0.01)

    for d, velocity in zip(diameters, v.T):
        eta, phi = theory.fit(t, velocity/amplitude, d, 2*np.pi*frequency)
        s = 2*np.pi*frequency*theory.relaxation_time(d)
        print(
            f"{1e6*d:g} um: entrainment {eta*np.sqrt(1 + s*s) - 1:.1e},"
            f" lag {phi - lag - np.arctan(s):.1e} rad off"
        )
        assert eta == pytest.approx(1/np.sqrt(1 + s*s), rel=0.01)
        assert phi - lag == pytest.approx(np.arctan(s), abs=0.01)
