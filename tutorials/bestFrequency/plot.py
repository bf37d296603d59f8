"""The efficiency over the frequency, and the optimum, against theory."""

import os
import sys

sys.path.append(os.environ["ACOUSTICDEM_DIR"] + "/bin")
import runTables  # noqa: E402, finds a Python that has what follows

import acousticDEM  # noqa: E402
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
import smoluchowski  # noqa: E402
from studyPage import label_axis  # noqa: E402

SMALL, LARGE, CONCENTRATION = 5e-6, 20e-6, 2.3e11
SPL, DISSIPATION, END = 137, 20, 0.0625

try:
    points = acousticDEM.csv("study/points.csv")
    optimum = acousticDEM.csv("study/optimum.csv")
except acousticDEM.TableError as missing:
    sys.exit(f"ERROR: {missing}: run Allrun first")

(best,), (error,) = optimum["frequency"], optimum["frequency_error"]
tau = smoluchowski.relaxation_time(np.array([SMALL, LARGE]))
theory = 1/(2*np.pi*np.sqrt(tau.prod()))

edges = smoluchowski.sections(0.98*SMALL, 4*LARGE, 12)
start = np.zeros(len(edges) - 1)
for d, share in ((SMALL, 10/11), (LARGE, 1/11)):
    start[np.searchsorted(edges, d) - 1] = share*CONCENTRATION
frequencies = np.geomspace(60, 800, 61)
u0 = smoluchowski.velocity_amplitude(SPL)


def efficiency(kernel):
    gone = []
    for frequency in frequencies:
        n = smoluchowski.PopulationBalance(edges, kernel(frequency)).solve(
            start, [0, END])
        gone.append(1 - n[-1].sum()/n[0].sum())
    return 100*np.array(gone)


figure, axes = plt.subplots(figsize=(6.4, 4.2), layout="constrained")
axes.errorbar(points["frequency"], 100*points["efficiency"],
              100*points["efficiency_error"], fmt="o", ms=4, capsize=3,
              label="runs, mean of the seeds")
axes.plot(frequencies, efficiency(
    lambda f: smoluchowski.orthokinetic(f, u0)), color="0.5",
    label="population balance, full refill")
axes.axvspan(best - error, best + error, color="C2", alpha=0.3, lw=0)
axes.axvline(best, color="C2", label="optimum of the runs, standard error")
axes.axvline(theory, color="0.5", ls="--",
             label=r"theory, $\omega^2\tau_1\tau_2 = 1$")
label_axis(axes, frequencies)
axes.set_ylim(bottom=0)
axes.set_xlabel("frequency [Hz]")
axes.set_ylabel(f"efficiency after {1e3*END:g} ms [%]")
axes.legend(loc="lower center", frameon=True)
runTables.save(figure, "bestFrequency.png")
print(f"optimum {best:.0f} ± {error:.0f} Hz, theory {theory:.0f} Hz")
