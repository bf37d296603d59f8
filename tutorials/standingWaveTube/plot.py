"""Pressure and velocity along the tube against linear theory.

Reads what the function objects have written, prints the amplitude and the
frequency of the pressure at the wall, and writes standingWaveTube.png.
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

figure = plt.figure(figsize=(7, 6.4), layout="constrained")
grid = figure.add_gridspec(2, 2, height_ratios=(1.2, 1))
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
    label = f"{t*FREQUENCY:.3g}"
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

pressure.set(xlabel="x [cm]", ylabel="sound pressure [Pa]")
velocity.set(
    xlabel="x [cm]", ylabel="velocity [mm/s]", ylim=(-1100*u0, 700*u0)
)
velocity.legend(
    title="time [periods]", loc="upper center", ncol=3, handletextpad=0.2,
    columnspacing=1,
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
    xlabel="time [periods]", ylabel="pressure at the wall [Pa]",
    xlim=(0, t[-1]*FREQUENCY), ylim=(-1.1*AMPLITUDE, 1.5*AMPLITUDE),
)
history.legend(loc="upper right", ncol=2)
pressure.set_title("lines: linear theory")
velocity.set_title("symbols: acousticDEMFoam")
runTables.save(figure, case/"standingWaveTube.png")


def wave(first, last):
    """Amplitude and phase between two times in periods, by least squares."""
    some = (t*FREQUENCY > first) & (t*FREQUENCY <= last)
    columns = np.array([np.cos(omega*t[some]), np.sin(omega*t[some])]).T
    a, b = np.linalg.lstsq(columns, series[some, 1] - AMBIENT, rcond=None)[0]
    return np.hypot(a, b), np.arctan2(b, a)


periods = int(np.floor(t[-1]*FREQUENCY + 0.01))
if periods > 1:
    (start, early), (end, late) = wave(0, 1), wave(periods - 1, periods)
    lag = (late - early + np.pi) % (2*np.pi) - np.pi
    print(f"Amplitude at the wall: {start:.3f} Pa in period 1, {end:.3f} Pa in"
          f" period {periods}; theory {AMPLITUDE*np.cos(k*cell):.3f} Pa\n"
          f"Frequency: {-100*lag/(2*np.pi*(periods - 1)):+.3f} % from theory")
