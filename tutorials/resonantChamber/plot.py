"""A map of the level, and how the level control reached it.

Reads what the function object soundPressureLevel has written and the log;
prints the level that was reached and writes resonantChamber.png.
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

chamber = dict(
    re.findall(
        r"^(\w+)\s+([-+.\deE]+)\s*;", (case/"system/chamber").read_text(), re.M
    )
)
LENGTH = float(chamber["length"])  # m
WIDTH = float(chamber["width"])  # m
LEVEL = float(chamber["SPL"])  # dB
SHAPE = 16, int(chamber["cellsAlong"])

# The last time with a field of the level
time = runTables.last_time(case, "SPL")


def cells(name):
    """Values in the cells, a row for each y."""
    text = (time/name).read_text().split("internalField", 1)[1]
    values = text.split("(", 1)[1].split("\n)", 1)[0]
    values = np.array(re.sub(r"[()]", " ", values).split(), float)
    return values.reshape(SHAPE + (-1,)).squeeze()


x = 100*LENGTH*(np.arange(SHAPE[1]) + 0.5)/SHAPE[1]
y = 100*WIDTH*(np.arange(SHAPE[0]) + 0.5)/SHAPE[0]

figure, (top, middle, bottom) = plt.subplots(
    3, 1, figsize=(7, 7.6), layout="constrained",
    gridspec_kw={"height_ratios": (1, 1, 1)},
)

for axes in (top, middle):
    axes.grid(False)
level = cells("SPL")
mesh = top.pcolormesh(
    x, y, level, shading="nearest", cmap="inferno", vmin=LEVEL - 25
)
top.contour(x, y, level, np.arange(120, 160, 5), colors="w", linewidths=0.5)
figure.colorbar(mesh, ax=top, label="level [dB]")

speed = cells("UAmp1")
mesh = middle.pcolormesh(x, y, speed, shading="nearest", cmap="viridis")
figure.colorbar(mesh, ax=middle, label="velocity [m/s]")

for axes in (top, middle):
    axes.plot([0, 0], [25*WIDTH, 75*WIDTH], color="C0", lw=6, clip_on=False)
    axes.plot(
        [100*LENGTH]*2, [87.5*WIDTH, 100*WIDTH], color="w", lw=6, clip_on=False
    )
    axes.set(ylabel="y [cm]", xlabel="x [cm]", aspect="equal")
top.plot(100*LENGTH, 0, "o", color="C2", ms=8, clip_on=False)
top.set_title(
    f"{LEVEL:g} dB in the corner (green); loudspeaker blue, opening white"
)

# The log has a line per period
log = case/"log.acousticDEMFoam"
if not log.exists():
    runTables.fail(f"there is no {log}: has the case been run?")
history = np.array(
    re.findall(
        r"^Level, period (\d+): (?:below )?([-+.\de]+) dB at .*,"
        r" drive ([-+.\de]+) ",
        log.read_text(), re.M,
    ),
    dtype=float,
)
if not history.size:
    runTables.fail(f"{log} has no line 'Level, period': the run was too short")
period, reached, drive = history.T
bottom.axhspan(LEVEL - 0.1, LEVEL + 0.1, color="C2", alpha=0.4)
bottom.plot(period, reached, "o-", ms=3, color="k")
bottom.set(
    xlabel="time [periods]", ylabel="level at the point [dB]",
    ylim=(LEVEL - 25, LEVEL + 3),
)
right = bottom.twinx()
right.plot(period, drive, color="C0")
right.set_ylabel("velocity of the loudspeaker [m/s]", color="C0")
right.grid(False)
right.set_ylim(0, None)

outside = period[np.abs(reached - LEVEL) > 0.25]
print(
    f"Level at the point {reached[-1]:.2f} dB, velocity of the loudspeaker"
    f" {drive[-1]:.3f} m/s in period {period[-1]:g};\nwithin 0.25 dB of"
    f" {LEVEL:g} dB after period {outside[-1] if outside.size else 0:g}"
)
runTables.save(figure, case/"resonantChamber.png")
