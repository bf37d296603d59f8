"""The volume over the diameter: of the laboratory's table, of the particles at
the start, and of those at the end; ductAsh.png."""

import os
import pathlib
import sys

case = pathlib.Path(__file__).resolve().parent
sys.path.append(os.environ.get("ACOUSTICDEM_DIR", f"{case}/../..") + "/bin")
try:
    import runTables  # finds a Python that has what follows
except ImportError:
    sys.exit("ERROR: first source the environment: . bin/environment")

import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

ash = np.loadtxt(case/"constant/ash.csv", delimiter=";", skiprows=3)
table = runTables.columns(case, "aerosol", "agglomeration")
# Without what is below and above the bins of the report
times, _, masses, edges = runTables.sizes(case, "aerosol")
masses, edges = masses[:, 1:-1], edges[1:-1]


def density(volumes, edges):
    """Per cent of the volume per decade of the diameter."""
    return 100*volumes/volumes.sum()/np.diff(np.log10(edges))


figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
of_table = np.append(ash[:, 0], ash[-1, 1])
axes.stairs(density(ash[:, 2], of_table), of_table, fill=True, color="0.85",
            label="the laboratory's table")
for k, label in ((0, "particles at the start"), (-1, "particles at the end")):
    axes.stairs(density(masses[k], edges), 1e6*edges,
                color=f"C{-k}", lw=1.5,
                label=f"{label}, {1e3*times[k]:.0f} ms")
axes.set_xscale("log")
axes.xaxis.set_major_formatter("{x:g}")
axes.set_xlabel("diameter [µm]")
axes.set_ylabel("volume per decade [%]")
axes.legend(loc="upper left")

print("time [ms]   particles   efficiency [%]   CMD [um]   MMD [um]")
for i in (0, len(table["time_s"])//2, -1):
    print(f"{1e3*table['time_s'][i]:9.1f}{table['number'][i]:12.0f}"
          f"{100*table['efficiency'][i]:17.2f}"
          f"{1e6*table['CMD_m'][i]:11.2f}{1e6*table['MMD_m'][i]:11.2f}")

runTables.save(figure, case/"ductAsh.png")
