"""The mean flow that sound drives between two plates, against theory.

Reads the fields that the function object soundPressureLevel has written at the
last time; writes streaming.png.
"""

import os
import re
import sys
from pathlib import Path

case = Path(__file__).resolve().parent
sys.path.append(os.environ.get("ACOUSTICDEM_DIR", f"{case}/../..") + "/bin")
try:
    import runTables  # finds a Python that has what follows
except ImportError:
    sys.exit("ERROR: first source the environment: . bin/environment")

import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

tube = {
    name: float(value) for name, value in re.findall(
        r"^(\w+)\s+([-+.\deE]+)\s*;", (case/"system/tube").read_text(), re.M
    )
}
LENGTH, HALF_GAP = tube["length"], tube["halfGap"]  # m
SOUND_SPEED = tube["soundSpeed"]  # m/s
SHAPE = int(tube["cellsAcross"]), int(tube["cellsAlong"])
OMEGA = np.pi*SOUND_SPEED/LENGTH
DELTA = np.sqrt(2*tube["viscosity"]/tube["density"]/OMEGA)

# The last time with a mean velocity
time = runTables.last_time(case, "UMean")


def cells(name):
    """Values in the cells, a row for each distance from the plate."""
    text = (time/name).read_text().split("internalField", 1)[1]
    values = text.split("(", 1)[1].split("\n)", 1)[0]
    values = np.array(re.sub(r"[()]", " ", values).split(), float)
    return values.reshape(SHAPE + (-1,)).squeeze()


# Centres of the cells: along, and from the plate
x = LENGTH*(np.arange(SHAPE[1]) + 0.5)/SHAPE[1]
growth = tube["grading"]**(1/(SHAPE[0] - 1))
edges = np.concatenate([[0], np.cumsum(growth**np.arange(SHAPE[0]))])
edges *= HALF_GAP/edges[-1]
y = 0.5*(edges[1:] + edges[:-1])

mean = cells("UMean")
swing = cells("UAmp1")[-1]
u0 = (swing@np.sin(np.pi*x/LENGTH))/np.sum(np.sin(np.pi*x/LENGTH)**2)
rayleigh = 3*u0**2/(8*SOUND_SPEED)

# What goes with sin(2 k x) of the flow along the plates
shape = np.sin(2*np.pi*x/LENGTH)
profile = -(mean[..., 0]@shape)/np.sum(shape**2)/rayleigh

# Rayleigh's flow outside of the layers; its strength by least squares
eta = 1 - y/HALF_GAP
outer = y > 5*DELTA
theory = (3*eta**2 - 1)/2
columns = np.array([theory, np.ones_like(y)]).T[outer]


def strength(flow):
    """The share of Rayleigh's flow in it, by least squares."""
    return np.linalg.lstsq(columns, flow[outer], rcond=None)[0][0]


def exact(position):
    """The mean flow between plates that are narrow against the wavelength.

    Over Rayleigh's velocity, at distances from the plate. The mean of the
    momentum equation along the plates, to second order in the amplitude, with
    the linear wave h = 1 - cosh(K y)/cosh(K H), y from the middle; no net flow.
    """
    grid = np.linspace(0, HALF_GAP, 4000)

    def integral(f):
        return np.concatenate(
            [[0], np.cumsum(0.5*(f[1:] + f[:-1])*np.diff(grid))]
        )

    def flow(stress):
        """Velocity with that mean stress over the density, none at the plate"""
        slope = integral(stress)
        return 2*(slope - slope[-1])/(OMEGA*DELTA**2)

    K = (1 - 1j)/DELTA
    h = 1 - (
        np.exp(K*(grid - HALF_GAP))*(1 + np.exp(-2*K*grid))
        / (1 + np.exp(-2*K*HALF_GAP))
    )
    average = integral(h)[-1]/HALF_GAP

    # Over U dU/dx: the stresses <u u> along and <u v> across, and the mass that
    # the wave carries
    stress = integral(abs(h)**2) - 0.5*np.real(
        h*np.conj(integral(h - average))
    )
    drift = 0.5*np.real(average*np.conj(h)/(1j*OMEGA))

    driven, pushed = flow(stress), flow(grid)
    pressure = (
        -(integral(driven)[-1] + integral(drift)[-1])/integral(pushed)[-1]
    )
    velocity = (driven + pressure*pushed)*OMEGA/2*8/3
    return -np.interp(HALF_GAP - position, grid, velocity)


figure, (top, bottom) = plt.subplots(
    2, 1, figsize=(7, 6.8), layout="constrained",
    gridspec_kw={"height_ratios": (1, 1.1)},
)

# Streamlines want even distances
even = np.linspace(y[0], y[-1], 60)
flow = [
    np.array([np.interp(even, y, column) for column in mean[..., c].T]).T
    for c in (0, 1)
]
speed = 1e3*np.hypot(*flow)
top.grid(False)
image = top.pcolormesh(
    100*x, 1e3*even, speed, shading="nearest", cmap="viridis"
)
# In the plane as it is drawn, which is much higher than it is
top.streamplot(
    100*x, 1e3*even, 100*flow[0], 1e3*flow[1], color="w", linewidth=0.7,
    arrowsize=0.8, density=(1.6, 0.9),
)
figure.colorbar(image, ax=top, label="mean speed [mm/s]")
top.set(
    xlabel="distance from the piston [cm]",
    ylabel="distance from the plate [mm]",
    xlim=(0, 100*LENGTH), ylim=(0, 1e3*HALF_GAP),
    title="the mean flow, from the plate (below) to the middle of the gap",
)

fine = np.linspace(0, 1, 200)
bottom.plot(
    (3*(1 - fine)**2 - 1)/2, 1e3*HALF_GAP*fine, color="0.6", lw=2.5,
    label="Rayleigh, outside of the layers, plates far apart",
)
bottom.plot(
    exact(HALF_GAP*fine), 1e3*HALF_GAP*fine, color="C0",
    label="theory for a gap of this width",
)
bottom.plot(profile, 1e3*y, "o", ms=3, color="k", label="acousticDEMFoam")
bottom.axhspan(0, 1e3*DELTA, color="C1", alpha=0.3, lw=0, label="Stokes layer")
bottom.set(
    xlabel="mean velocity towards the nodes of the velocity [$3u_0^2/8c$]",
    ylabel="distance from the plate [mm]", ylim=(0, 1e3*HALF_GAP),
)
bottom.legend(loc="upper right", frameon=True, framealpha=1)

runTables.save(figure, case/"streaming.png")

print(
    f"Velocity amplitude in the middle {u0:.3f} m/s; streaming"
    f" {strength(profile):.3f} of 3 u0^2/(8 c) = {1e3*rayleigh:.3f} mm/s,"
    f" theory for this gap {strength(exact(y)):.3f}; profiles differ by up to"
    f" {np.abs(profile - exact(y)).max():.3f}"
)
