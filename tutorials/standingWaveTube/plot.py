"""Pressure and velocity along the tube against linear theory.

Reads what the function objects have written, writes standingWaveTube.png.
"""

import os
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

LENGTH = 0.1226  # m
FREQUENCY = 1400.0  # Hz, of the time axis
AMBIENT = 101325.0  # Pa
AMPLITUDE = 28.28  # Pa: 120 dB
DENSITY = 1.2039  # kg/m3
SOUND_SPEED = 343.25  # m/s

omega = np.pi*SOUND_SPEED/LENGTH
k = np.pi/LENGTH
u0 = AMPLITUDE/(DENSITY*SOUND_SPEED)

plt.rcParams.update({"font.size": 9, "axes.grid": True, "grid.alpha": 0.3})
figure = plt.figure(figsize=(9, 6), constrained_layout=True)
grid = figure.add_gridspec(2, 2)
pressure = figure.add_subplot(grid[0, 0])
velocity = figure.add_subplot(grid[0, 1])
history = figure.add_subplot(grid[1, :])

# Along the tube, over half a period
times = runTables.of_times(case.glob("postProcessing/profile/*"))
if not times:
    runTables.fail(f"no profiles in {case}: has the case been run?")
colours = plt.cm.viridis(np.linspace(0, 0.85, len(times)))
x = np.linspace(0, LENGTH, 200)

for directory, colour in zip(times, colours):
    t = float(directory.name)
    velocities = case/"postProcessing/velocityProfile"/directory.name
    label = f"{t*FREQUENCY:.3g} periods"
    p = runTables.Table(directory/"axis_p.xy").numbers()
    u = runTables.Table(velocities/"axis_U.xy").numbers()
    if not p.size or not u.size:
        runTables.fail(f"the tables of {directory} are empty")

    pressure.plot(
        100*x, AMPLITUDE*np.cos(k*x)*np.cos(omega*t), color=colour, lw=1
    )
    pressure.plot(100*p[:, 0], p[:, 1] - AMBIENT, "o", ms=3, color=colour)
    velocity.plot(
        100*x, 1e3*u0*np.sin(k*x)*np.sin(omega*t), color=colour, lw=1
    )
    velocity.plot(
        100*u[:, 0], 1e3*u[:, 1], "o", ms=3, color=colour, label=label
    )

pressure.set(xlabel="x / cm", ylabel="sound pressure / Pa")
velocity.set(xlabel="x / cm", ylabel="velocity / (mm/s)")
velocity.legend(
    title="after", loc="center left", bbox_to_anchor=(1, 0.5), frameon=False
)

# Over all periods, near a wall
series = runTables.series(case/"postProcessing/history", "p")
t = series[:, 0]
cell = 0.5*LENGTH/25
history.plot(
    t*FREQUENCY, AMPLITUDE*np.cos(k*cell)*np.cos(omega*t),
    color="0.6", lw=2.5, label="theory",
)
history.plot(
    t*FREQUENCY, series[:, 1] - AMBIENT, "k", lw=0.8, label="acousticDEMFoam"
)
history.set(
    xlabel="time / periods", ylabel="pressure at the wall / Pa",
    xlim=(0, t[-1]*FREQUENCY), ylim=(-1.1*AMPLITUDE, 1.45*AMPLITUDE),
)
history.legend(loc="upper right", ncol=2, framealpha=1)

figure.suptitle(
    "Standing wave in a closed tube, 120 dB, 50 cells per wavelength, "
    "200 steps per period\nlines: linear theory, symbols: acousticDEMFoam",
    fontsize=10,
)
figure.savefig(case/"standingWaveTube.png", dpi=150)
