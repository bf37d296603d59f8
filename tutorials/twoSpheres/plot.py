"""How fast the wakes of two spheres bring them together; twoSpheres.png.

Reads the contacts of each frequency and wake, and prints the times beside those
that are known: of Oseen's wake from afar (Runge-Kutta for the equations of a
pair), and of the full history integral, of which `memory` has the first terms
and `history` a sum (approachTest in doc/verification.md). Of times below a
period, 5 ms at 200 Hz, much depends on the phase of the sound at the start.
"""

import os
import pathlib
import re
import sys

case = pathlib.Path(__file__).resolve().parent
sys.path.append(os.environ.get("ACOUSTICDEM_DIR", f"{case}/../..") + "/bin")
try:
    import runTables  # finds a Python that has what follows
except ImportError:
    sys.exit("ERROR: first source the environment: . bin/environment")

import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

WAKES = {"Oseen": "C0o-", "ProudmanPearson": "C2^:", "memory": "C3s--",
         "history": "C1d-"}
DISTANCES = [30, 50, 100, 200]  # um, in the order of the ids of the pairs
KNOWN = {  # ms, at Hz and um, of the experiment as it is here
    "Oseen": {(200, 100): 21.5, (1000, 100): 8.94, (1000, 200): 23.2},
    "history": {(1000, 100): 11.3, (1000, 200): 44.9},
}

EXPERIMENT = {
    name: float(value) for name, value in re.findall(
        r"^(\w+)\s+([-+.\deE]+)\s*;", (case/"system/experiment").read_text(),
        re.M
    )
}
VELOCITY, DIAMETER = EXPERIMENT["velocity"], EXPERIMENT["diameter"]  # m/s, m
if (VELOCITY, DIAMETER, EXPERIMENT["density"]) != (0.44, 8e-6, 2400):
    KNOWN = {}


def meetings(frequency, wake):
    """Times [ms] at which the pairs meet; not a number if they do not."""
    table = runTables.columns(case/f"sweep{frequency}", wake, "contacts")
    times = np.full(len(DISTANCES), np.nan)
    for time, *ids in zip(table["time_s"], table["id1"], table["id2"]):
        pair = int(min(ids))//2
        if {*ids} != {2*pair, 2*pair + 1}:
            runTables.fail(f"{case}/sweep{frequency}: spheres of two pairs have"
                           " met")
        times[pair] = 1e3*time
    return times


frequencies = sorted(
    int(folder.name[5:]) for folder in case.glob("sweep*")
    if re.fullmatch(r"sweep\d+", folder.name)
)
if not frequencies:
    runTables.fail(f"there are no runs in {case}: ./Allrun makes them")
table = {
    wake: np.array([meetings(f, wake) for f in frequencies]) for wake in WAKES
}

print("Time until two spheres meet [ms], - if they have not\n")
print("[Hz]   [um]" + "".join(f"{wake:>17s}" for wake in WAKES)
      + ("    known" if KNOWN else ""))
for i, f in enumerate(frequencies):
    for j, distance in enumerate(DISTANCES):
        times = [table[wake][i, j] for wake in WAKES]
        known = [
            f"{wake} {values[f, distance]:g}"
            for wake, values in KNOWN.items() if (f, distance) in values
        ]
        print(f"{f:<7d}{distance:<5d}" + "".join(
            f"{time:16.2f} " if time > 0 else f"{'-':>16s} " for time in times
        ) + "   " + ", ".join(known))

figure, panels = plt.subplots(
    2, 2, figsize=(7, 6.4), sharex=True, sharey=True, layout="constrained"
)
for j, (distance, axes) in enumerate(zip(DISTANCES, panels.flat)):
    for wake, line in WAKES.items():
        axes.loglog(frequencies, table[wake][:, j], line, ms=4, label=wake)
        for (f, r), time in KNOWN.get(wake, {}).items():
            if r == distance and f in frequencies:
                axes.plot(f, time, "s", ms=9, mfc="none", color=line[:2])
    axes.set_title(f"from {distance} µm")
    axes.set_xticks([200, 500, 1000, 2000, 5000],
                    ["0.2k", "0.5k", "1k", "2k", "5k"])
    axes.set_yticks([2, 5, 10, 20, 50, 100], ["2", "5", "10", "20", "50", "100"])
    axes.minorticks_off()
for axes in panels[:, 0]:
    axes.set_ylabel("time until they meet [ms]")
for axes in panels[1]:
    axes.set_xlabel("frequency [Hz]")
panels[0, 0].legend(loc="upper left")
figure.suptitle(
    f"Two spheres of {1e6*DIAMETER:g} µm in line with the sound,"
    f" {VELOCITY:g} m/s at every frequency"
    + ("\n(squares: known by other means)" if KNOWN else "")
)
runTables.save(figure, case/"twoSpheres.png")
