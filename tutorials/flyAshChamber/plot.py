"""The sound level along the chamber against theory; writes soundLevel.png."""

import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

LENGTH = 0.1532  # m
FREQUENCY = 1400  # Hz
SOUND_SPEED = 343.25  # m/s
DENSITY = 1.2039  # kg/m3
LEVEL = 147  # dB
BOX = 0.0919  # m, where the aerosol is

case = pathlib.Path(__file__).resolve().parent
folder = max((case/"postProcessing"/"axis").iterdir(),
             key=lambda f: float(f.name))
x, _, p2 = np.loadtxt(folder/"axis_pMean_pPrime2Mean.xy", unpack=True)
u2 = np.loadtxt(folder/"axis_UPrime2Mean.xy")[:, 1]

level = 10*np.log10(p2/20e-6**2)
u0 = np.sqrt(2*u2)

k = 2*np.pi*FREQUENCY/SOUND_SPEED
amplitude = np.sqrt(2)*20e-6*10**(LEVEL/20)
s = np.linspace(0, LENGTH, 500)
p_theory = amplitude*np.abs(np.cos(k*(LENGTH - s)))
u_theory = amplitude/(DENSITY*SOUND_SPEED)*np.abs(np.sin(k*(LENGTH - s)))

figure, (top, bottom) = plt.subplots(2, 1, figsize=(7, 6), sharex=True)

with np.errstate(divide="ignore"):
    top.plot(1e3*s, 20*np.log10(p_theory/np.sqrt(2)/20e-6), color="0.6",
             label="linear theory")
top.plot(1e3*x, level, "o", ms=4, color="C0", label="computed")
top.set_ylim(120, 150)
top.set_ylabel("sound pressure level [dB]")
top.legend(frameon=False, loc="lower right")

bottom.plot(1e3*s, u_theory, color="0.6")
bottom.plot(1e3*x, u0, "o", ms=4, color="C0")
bottom.axvline(1e3*BOX, color="C3", lw=1)
bottom.text(1e3*BOX + 1, 0.1, "aerosol", color="C3")
bottom.set_ylabel("velocity amplitude [m/s]")
bottom.set_xlabel("distance from the piston [mm]")

for axes in (top, bottom):
    axes.grid(alpha=0.3)

figure.tight_layout()
figure.savefig(case/"soundLevel.png", dpi=150)

print(f"Sound level at the reflector: {level[-1]:.2f} dB"
      f" (expected {LEVEL} dB)")
print(f"Wrote {case/'soundLevel.png'}")
