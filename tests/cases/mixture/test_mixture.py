"""Populations of different densities in one box: settling, merging, restart."""

import re

import numpy as np
import pytest
from aerosolcase import AerosolCase
from aerosoltheory import DENSITY, relaxation_time

GRAVITY = 9.81
AEROSOL = "constant/aerosolProperties"

#: Heavy fine particles, and light coarse ones that fall onto them
POPULATIONS = """source mixture;
density 2300;
populations
{
    fine { count 1500; size { type monodisperse; diameter 5e-6; } }
    coarse
    {
        density 900;
        count 12;
        size { type monodisperse; diameter 20e-6; }
    }
}"""


@pytest.fixture(name="still")
def make_still(box):
    """Gas at rest, gravity, Stokes drag."""
    box.model("particles", POPULATIONS)
    box.model("wake", "type none;")
    box.model("timeStepping", "type eventDriven;")
    box.replace(
        "constant/acousticProperties", r"(?s)type.*antinode", "type quiescent;"
    )
    box.control("deltaT", "1e-4")
    box.control("writeInterval", "200")
    box.control("endTime", "0.04")
    return box


def test_aggregates_have_mass_volume_and_settling_of_their_parts(still):
    log = still.run("acousticDEMFoam")
    start, end = still.cloud("0"), still.cloud(still.times()[-1])

    # As they were asked for
    volume = np.pi/6*start["d"]**3
    assert np.unique(np.round(start["mass"]/volume)) == pytest.approx(
        [900, 2300]
    )
    assert "in 1.25e-10 m3" in log
    loading = start["mass"].sum()/1.25e-10
    assert float(
        re.search(r"mass concentration (\S+) kg/m3", log)[1]
    ) == pytest.approx(loading, rel=1e-5)

    # Conserved, also in each aggregate
    assert end["mass"].sum() == pytest.approx(start["mass"].sum(), rel=1e-12)
    assert (end["d"]**3).sum() == pytest.approx(
        (start["d"]**3).sum(), rel=1e-12
    )
    density = end["mass"]/(np.pi/6*end["d"]**3)
    mixed = (density > 901) & (density < 2299)
    print(mixed.sum(), "aggregates of both, densities", density[mixed])
    assert mixed.sum() > 5
    fine = end["primaries"][mixed] - 1
    assert end["mass"][mixed] == pytest.approx(
        np.pi/6*(900*20e-6**3 + fine*2300*5e-6**3), rel=1e-12
    )

    # Each settles as Stokes says for its own mass and size
    for name, which in (
        ("coarse", abs(density - 900) < 1), ("fine", abs(density - 2300) < 1),
        ("both", mixed),
    ):
        d, rho = end["d"][which], density[which]
        speed = relaxation_time(d, rho)*GRAVITY*(1 - DENSITY/rho)
        error = np.abs(-end["U"][which][:, 2]/speed - 1)
        # Some have merged a moment ago
        assert (error < 1e-5).sum() > 2, (name, error)


def test_restart_goes_on_with_the_same_particles(still, tmp_path):
    half = AerosolCase(tmp_path/"half", still.path)
    still.run("acousticDEMFoam")
    half.control("endTime", "0.02")
    half.run("acousticDEMFoam")
    half.control("endTime", "0.04")
    half.run("acousticDEMFoam")
    one, two = (case.cloud(case.times()[-1]) for case in (still, half))
    for name in one:
        assert np.array_equal(one[name], two[name]), name

    # A density that has changed would be ignored
    half.replace(AEROSOL, "density 900", "density 950")
    half.control("endTime", "0.05")
    log = half.run("acousticDEMFoam", status=1)
    assert "dictionary 'particles' has changed" in " ".join(log.split())
