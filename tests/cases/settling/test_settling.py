"""Particles that settle in quiescent gas, through the periodic faces."""

import numpy as np
import pytest
from aerosoltheory import DENSITY, VISCOSITY, relaxation_time

GRAVITY = 9.81
DIAMETERS = np.array([2e-6, 5e-6, 10e-6, 20e-6, 40e-6])
LENGTH = 0.5e-3
END = 0.1


def factor(d, v):
    """Drag of Schiller and Naumann over that of Stokes."""
    return 1 + 0.15*(DENSITY*d*v/VISCOSITY)**0.687


def theory(drag):
    """Displacement of each diameter at the end, from rest, by Heun's method."""
    tau = relaxation_time(DIAMETERS)
    g = GRAVITY*(1 - DENSITY/2300)

    if drag == "Stokes":
        return tau*g*(END - tau*(1 - np.exp(-END/tau)))

    h = 5e-6
    v = np.zeros(len(DIAMETERS))
    z = np.zeros(len(DIAMETERS))
    k = h/tau

    for _ in range(round(END/h)):
        a = h*g - k*v*factor(DIAMETERS, v)
        b = h*g - k*(v + a)*factor(DIAMETERS, v + a)
        z += h*(v + 0.5*a)
        v += 0.5*(a + b)
    return z


@pytest.mark.parametrize("drag", ["Stokes", "SchillerNaumann"])
def test_settles_as_far_as_theory_says(box, drag):
    start = [(0.0612 + 5e-5*i, 0, 0) for i in range(len(DIAMETERS))]
    box.particles(list(zip(start, DIAMETERS)))
    box.model("wake", "type none;")
    box.model("drag", f"type {drag}; slipCorrection Cunningham;")
    box.replace(
        "constant/acousticProperties", r"(?s)type.*antinode", "type quiescent;"
    )
    box.control("deltaT", "1e-4")
    box.control("endTime", str(END))
    box.control("writeInterval", "1000")
    box.run("acousticDEMFoam")

    end = box.cloud(box.times()[-1])
    assert np.array_equal(end["d"], DIAMETERS)
    assert float(box.times()[-1]) == pytest.approx(END)

    # The largest falls through the box many times: unwind it
    expected = theory(drag)
    fallen = -end["position"][:, 2]
    fallen += LENGTH*np.round((expected - fallen)/LENGTH)
    error = fallen/expected - 1
    print(drag, "displacement", fallen, "error", error)

    assert expected[-1] > 5*LENGTH
    assert (np.abs(error) < 1e-3).all()

    # Straight down
    assert end["position"][:, :2] == pytest.approx(np.array(start)[:, :2])
    assert (end["U"][:, :2] == 0).all()
