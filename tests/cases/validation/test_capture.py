"""Pairs of the validation by brute force: limits, and the solver itself."""

import shutil
import subprocess
import sys

import numpy as np
import pytest
from foamcase import ROOT

FOLDER = ROOT/"tutorials"/"validation"/"flyAsh"
sys.path.insert(0, str(FOLDER))
import capture  # noqa: E402
import refill  # noqa: E402
import smoluchowski  # noqa: E402


@pytest.mark.parametrize("small", (0.5e-6, 2e-6, 4.8e-6))
def test_without_wakes_all_is_captured(small):
    u0 = smoluchowski.velocity_amplitude(147)
    captured, swept = capture.stroke(
        capture.Pairs(5e-6, small, 1400, u0, "none")
    )
    assert captured == pytest.approx(swept, rel=0.015)
    pair = capture.Pairs(8e-6, small, 0, 0, "none", gravity=9.81)
    if small > 1e-6:
        assert capture.fall(pair, 50) == pytest.approx(1, abs=2.4*1.2/50)


def tracer(u):
    """It follows the wake of 10 um, in Stokes' flow, and has none."""
    pair = capture.Pairs(10e-6, u, 0, 0, "Oseen", gravity=9.81)
    pair.nu = 1e6
    pair.tau[1] = 5e-6
    pair.reach[1] = 0
    return pair


@pytest.mark.parametrize("small", (3e-6, 10e-6))
def test_tracer_in_the_flow_of_Stokes(small):
    """Stream function: b^2 (1 - 3a/2r + a^3/2r^3) is the same at contact."""
    pair, far = tracer(small), 10

    def part(R):
        q = 5e-6/R
        return 1 - 1.5*q + 0.5*q**3

    E = capture.fall(pair, 100, far)
    exact = part(pair.R)/part(far*pair.R)
    print(small, E, exact)
    assert E == pytest.approx(exact, rel=0.04)


def test_nobody_meets_a_point_force(monkeypatch):
    """Without the dipole gas is faster than the source where 3a/2r > 1."""
    def Stokeslet(s, U, a, reach, nu):
        r = np.sqrt((s**2).sum(axis=0))
        w = -0.75*a*(U/r + (U*s).sum(axis=0)*s/r**3)
        return np.where(r < reach, w, 0)

    monkeypatch.setattr(capture, "oseen", Stokeslet)
    assert capture.fall(tracer(4e-6), 30, 10) == 0
    assert capture.fall(tracer(11e-6), 30, 10) > 0


def test_cloud_droplets():
    """Radii of 10 and 5 um: 0.033, Hall (J. Atmos. Sci. 37, 2486, 1980)."""
    pair = capture.Pairs(20e-6, 10e-6, 0, 0, "disturbed", 9.81, 1000)
    E = capture.fall(pair, 40, wide=0.4)
    print(E)
    assert E == pytest.approx(0.033, abs=0.006)


def test_same_pairs_as_the_solver(tmp_path):
    """1000 pairs, far from one another, that begin anywhere on their way."""
    base = tmp_path/"base"
    shutil.copytree(FOLDER/"case", base,
                    ignore=shutil.ignore_patterns("[0-9]*", "log.*"))
    subprocess.run(["blockMesh"], cwd=base, check=True,
                   stdout=subprocess.DEVNULL)
    m, apart = 10, 8e-4
    box = refill.Box(base, tmp_path/"pairs", m**3, 1)
    box.length = m*apart
    file = box.folder/"constant"/"aerosolProperties"
    text = file.read_text().replace(
        f"{refill.length(m**3):.17g}", f"{box.length:.17g}"
    )
    for old, new in (("type Stokes;", "type SchillerNaumann;"),
                     ("wake { type none; }", "wake { type Oseen; }")):
        assert old in text
        text = text.replace(old, new)
    file.write_text(text)

    pair = capture.Pairs(5e-6, 1e-6, refill.FREQUENCY, refill.U0)
    pair.reach = pair.ranges(3e-6)
    random = np.random.default_rng(3)
    x = random.uniform(-3e-4, 3e-4, m**3)
    x = np.where(abs(x) < 1.01*pair.R, 3e-4, x)
    b = 1.3*pair.R*np.sqrt(random.random(m**3))
    angle = 2*np.pi*random.random(m**3)
    r = np.array([x, b*np.cos(angle), b*np.sin(angle)])
    middle = apart*(np.indices((m, m, m)).reshape(3, -1) + 0.5)
    _, _, contacts, _ = box.run(
        np.hstack([middle - 0.5*r, middle + 0.5*r]).T,
        np.repeat(pair.d, m**3),
    )

    y = np.zeros((9, m**3))
    y[:3] = r
    y[3], y[6] = refill.U0*np.imag(1/(1 + 1j*pair.omega*pair.tau))
    T = refill.PERIOD
    when = pair.captured(-0.25*T, y, 0.75*T)
    when = 0.25*T + np.sort(when[np.isfinite(when)])
    print(len(when), len(contacts))
    assert len(when) == len(contacts) > 100
    assert np.sort(contacts[:, 0]) == pytest.approx(when, abs=2e-3*T)
