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


@pytest.mark.parametrize("small", (0.5e-6, 2e-6))
def test_without_wakes_all_is_captured(small):
    u0 = smoluchowski.velocity_amplitude(147)
    captured, swept = capture.stroke(
        capture.Pairs(5e-6, small, 1400, u0, "none")
    )
    assert captured == pytest.approx(swept, rel=0.015)
    pair = capture.Pairs(8e-6, small, 0, 0, "none", gravity=9.81)
    if small > 1e-6:
        assert capture.fall(pair, 50) == pytest.approx(1, abs=2.4*1.2/50)


def test_half_and_twice_the_steps():
    """The same pairs meet."""
    u0 = smoluchowski.velocity_amplitude(147)
    met = [capture.stroke(capture.Pairs(3e-6, 1.5e-6, 1400, u0, fine=fine),
                          (32, 16))[0] for fine in (0.5, 1, 2)]
    assert met[1] > 0
    assert met == pytest.approx([met[1]]*3, rel=0.01)


def tracer(d, tau):
    """It follows the wake of 10 um, in Stokes' flow, and has none."""
    pair = capture.Pairs(10e-6, d, 0, 0, "Oseen", gravity=9.81)
    pair.nu = 1e6
    pair.tau[1] = tau
    pair.reach[1] = 0
    return pair


def test_tracer_in_the_flow_of_Stokes():
    """Stream function: b^2 (1 - 3a/2r + a^3/2r^3) is the same at contact."""
    far, cells = 4, 60

    def part(R):
        q = 5e-6/R
        return 1 - 1.5*q + 0.5*q**3

    R = tracer(10e-6, 1).R
    exact = np.sqrt(part(R)/part(far*R))
    wide = 1.3*exact

    # What is left of its inertia is of first order
    b1, b2 = (np.sqrt(capture.fall(tracer(10e-6, tau), cells, far, wide))
              for tau in (1e-5, 2e-5))
    print(b1, b2, exact)
    assert 2*b1 - b2 == pytest.approx(exact, abs=1.5*wide/cells)


def test_nobody_meets_a_point_force(monkeypatch):
    """Without the dipole gas is faster than the source where 3a/2r > 1."""
    def Stokeslet(s, U, a, reach, nu):
        r = np.sqrt((s**2).sum(axis=0))
        w = -0.75*a*(U/r + (U*s).sum(axis=0)*s/r**3)
        return np.where(r < reach, w, 0)

    monkeypatch.setattr(capture, "oseen", Stokeslet)
    assert capture.fall(tracer(4e-6, 2e-5), 30, 4) == 0
    assert capture.fall(tracer(11e-6, 2e-5), 30, 4) > 0.1


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
