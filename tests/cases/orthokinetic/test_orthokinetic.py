"""Orthokinetic agglomeration alone stops: its swept paths are emptied once.

Gas that oscillates alike everywhere, no wakes, no gravity: particles move to
and fro on lines, and the motion of any two relative to each other repeats each
period. Those that begin on their periodic orbits meet within the first period
or never; only those that have merged sweep a new path once more. Any motion
across the lines refills the paths, and must be seen to do so.
"""

import numpy as np
import pytest
from aerosoltheory import relaxation_time

FREQUENCY = 1400
OMEGA = 2*np.pi*FREQUENCY
U0 = 1.5  # m/s
LENGTH = 0.5e-3  # m
CENTRE = np.array([0.0613, 0, 0])
NUMBER = 4000
PERIODS = 6


def aerosol():
    """Positions, diameters, and responses to the gas, sin(omega t)."""
    random = np.random.default_rng(1)
    x = CENTRE + LENGTH*(random.random((NUMBER, 3)) - 0.5)
    d = np.exp(random.normal(np.log(2e-6), np.log(1.6), NUMBER))
    d = d.clip(0.5e-6, 6e-6)

    # Without those that overlap from the start
    i, j, r = neighbours(x, 0.5*d)
    overlap = np.linalg.norm(r, axis=1) <= 0.5*(d[i] + d[j])
    keep = np.setdiff1d(np.arange(NUMBER), i[overlap])
    x, d = x[keep], d[keep]
    return x, d, 1/(1 + 1j*OMEGA*relaxation_time(d))


def neighbours(x, radius):
    """Pairs with paths so close that they touch, and their separations."""
    i, j = np.triu_indices(len(x), 1)
    r = x[j, 1:] - x[i, 1:]
    r -= LENGTH*np.round(r/LENGTH)
    near = (r**2).sum(axis=1) < (radius[i] + radius[j])**2
    i, j = i[near], j[near]
    r = x[j] - x[i]
    return i, j, r - LENGTH*np.round(r/LENGTH)


def pairs_that_meet(x, d, H):
    """Pairs of which the relative motion within a period leads to contact."""
    i, j, r = neighbours(x, 0.5*d)
    touch = 0.5*(d[i] + d[j])
    reach = np.sqrt(touch**2 - r[:, 1]**2 - r[:, 2]**2)

    # Displacements since t = 0: u0 Im(H (exp(i omega t) - 1)/(i omega))
    cycle = np.exp(1j*np.linspace(0, 2*np.pi, 721)) - 1
    moved = U0/OMEGA*np.imag(np.outer((H[j] - H[i])/1j, cycle))
    met = np.zeros(len(i), bool)
    for image in (-LENGTH, 0, LENGTH):
        along = r[:, :1] + image + moved
        met |= (along.min(axis=1) < reach) & (along.max(axis=1) > -reach)
    return met.sum()


def contacts_per_period(box, gravity):
    x, d, H = aerosol()
    v = U0*np.imag(H)
    lines = ["x,y,z,d,vx,vy,vz"] + [
        f"{a:.17g},{b:.17g},{c:.17g},{s:.17g},{u:.17g},0,0"
        for (a, b, c), s, u in zip(x, d, v)
    ]
    box.write("particles.csv", "\n".join(lines) + "\n")
    box.model(
        "particles", 'density 2300;\nsource list;\nfile "particles.csv";'
    )
    box.model("wake", "type none;")
    box.model("gravity", gravity)

    # An infinite wavelength: the same velocity everywhere
    box.replace(
        "constant/acousticProperties", r"(?s)type.*antinode",
        f"type travellingWave; frequency {FREQUENCY};"
        f" velocityAmplitude {U0}; gas {{ c 1e12; }}",
    )
    box.control("endTime", f"#eval{{ {PERIODS}.0/$frequency }}")
    box.run("acousticDEMFoam")

    table = box.table()
    assert len(table["time_s"]) == PERIODS + 1

    # Mass is neither lost nor made, nor is there momentum across
    assert np.ptp(table["mass_kg"]) < 1e-14*table["mass_kg"][0]
    return np.diff(table["contacts"]), pairs_that_meet(x, d, H), table


def test_stops_after_the_first_periods(box):
    contacts, pairs, table = contacts_per_period(box, "type none;")
    print(f"contacts {contacts}, of pairs that meet {pairs}")

    # A particle that meets two others has another path after the first
    assert contacts[0] == pytest.approx(pairs, rel=0.05)
    assert contacts[0] > 50
    assert contacts[1] < 0.2*contacts[0]
    assert contacts[2:].sum() <= 0.02*contacts[0]

    for axis in "yz":
        assert (table[f"momentum_{axis}_kg_m_per_s"] == 0).all()


def test_goes_on_where_gravity_moves_particles_across(box):
    contacts, _, _ = contacts_per_period(
        box, "type uniform; value (0 0 -9.81);"
    )
    print(f"contacts with gravity {contacts}")
    assert contacts[2:].mean() > 0.1*contacts[0]
