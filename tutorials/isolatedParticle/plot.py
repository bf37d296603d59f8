"""Particles in a standing wave against the analytic solution.

A Stokes particle of relaxation time tau, at rest at t = 0 in gas that moves as
u0 sin(omega t), moves as

    v = eta u0 (sin(omega t - phi) + sin(phi) exp(-t/tau)),

    eta = 1/sqrt(1 + s^2),   phi = atan(s),   s = omega tau.

Reads the particles of all times, fits the amplitude and the phase of each, and
prints them beside theory. Writes isolatedParticle.png.
"""

import os
import re
import sys
from pathlib import Path

CASE = Path(__file__).resolve().parent
sys.path.append(os.environ.get("ACOUSTICDEM_DIR", f"{CASE}/../..") + "/bin")
try:
    import runTables  # finds a Python that has what follows
except ImportError:
    sys.exit("ERROR: first source the environment: . bin/environment")

import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

FREQUENCY = 1400.0  # Hz
LEVEL = 147.0  # dB
DENSITY, VISCOSITY, SOUND_SPEED, FREE_PATH = 1.204, 1.81e-5, 343.2, 66e-9
PARTICLE_DENSITY = 2300.0  # kg/m3

OMEGA = 2*np.pi*FREQUENCY
U0 = np.sqrt(2)*20e-6*10**(LEVEL/20)/(DENSITY*SOUND_SPEED)


def relaxation_time(d):
    """Stokes drag with the slip correction of Cunningham."""
    Kn = 2*FREE_PATH/d
    slip = 1 + Kn*(1.257 + 0.4*np.exp(-1.1/Kn))
    return PARTICLE_DENSITY*d**2*slip/(18*VISCOSITY)


def entrainment(d):
    return 1/np.sqrt(1 + (OMEGA*relaxation_time(d))**2)


def phase(d):
    return np.arctan(OMEGA*relaxation_time(d))


def velocity(d, t):
    """Of the particle, in amplitudes of the gas."""
    phi = phase(d)
    return entrainment(d)*(
        np.sin(OMEGA*t - phi) + np.sin(phi)*np.exp(-t/relaxation_time(d))
    )


def values(file):
    """The numbers of a list in an ascii file of OpenFOAM."""
    body = re.search(r"^\d+\s*\((.*)\)\s*$", file.read_text(), re.M | re.S)
    if not body:
        runTables.fail(f"{file} has no list of numbers")
    return np.array(re.sub("[()]", " ", body[1]).split(), float)


def read(case):
    """Times, diameters, and velocities along the tube: a row for each time."""
    times = runTables.of_times(
        f.parents[2] for f in case.glob("*/lagrangian/aerosol/d")
    )[1:]  # not the beginning, at rest
    if len(times) < 3:
        runTables.fail(f"too few times in {case} have particles: has it been"
                       " run to its end?")
    clouds = [folder/"lagrangian"/"aerosol" for folder in times]

    return (
        np.array([float(folder.name) for folder in times]),
        values(clouds[0]/"d"),
        np.array([values(cloud/"U")[::3] for cloud in clouds]),
    )


def fit(t, v, d, omega=OMEGA):
    """Amplitude and lag behind the sine, fitted beside the transient."""
    columns = [
        np.sin(omega*t), np.cos(omega*t), np.exp(-t/relaxation_time(d)),
    ]
    a, b, _ = np.linalg.lstsq(np.array(columns).T, v, rcond=None)[0]
    return np.hypot(a, b), np.arctan2(-b, a)


def plot(t, diameters, v, fits):
    figure = plt.figure(figsize=(7, 6.4), layout="constrained")
    grid = figure.add_gridspec(2, 2, height_ratios=[1.5, 1])
    motion = figure.add_subplot(grid[0, :])
    amplitude = figure.add_subplot(grid[1, 0])
    lag = figure.add_subplot(grid[1, 1], sharex=amplitude)
    colours = plt.cm.viridis(np.linspace(0, 0.9, len(diameters)))

    fine = np.linspace(0, t[-1], 1000)
    motion.plot(
        FREQUENCY*fine, np.sin(OMEGA*fine), color="0.6", lw=1, ls="--",
        label="gas",
    )
    for i, (d, colour) in enumerate(zip(diameters, colours)):
        motion.plot(FREQUENCY*fine, velocity(d, fine), color=colour, lw=1)
        motion.plot(
            FREQUENCY*t, v[:, i], "o", ms=3, color=colour,
            label=f"{1e6*d:g} µm",
        )
    motion.set(
        xlabel="time [periods]", ylabel="velocity [amplitudes of the gas]",
        xlim=(0, FREQUENCY*t[-1]), ylim=(-1.08, 1.08),
    )
    motion.legend(
        loc="lower center", bbox_to_anchor=(0.5, 1), ncol=len(diameters) + 1,
        columnspacing=1.2, handletextpad=0.3,
    )

    sizes = np.geomspace(0.5e-6, 30e-6, 300)
    amplitude.semilogx(1e6*sizes, entrainment(sizes), color="0.6")
    lag.semilogx(1e6*sizes, np.degrees(phase(sizes)), color="0.6")
    for d, colour, (eta, phi) in zip(diameters, colours, fits):
        amplitude.plot(1e6*d, eta, "o", color=colour)
        lag.plot(1e6*d, np.degrees(phi), "o", color=colour)
    amplitude.set(xlabel="diameter [µm]", ylabel="entrainment")
    lag.set(
        xlabel="diameter [µm]", ylabel="lag behind the gas [degrees]",
        yticks=[0, 30, 60, 90], xticks=[1, 2, 5, 10, 20],
        xticklabels=["1", "2", "5", "10", "20"],
    )
    lag.minorticks_off()

    figure.suptitle(
        f"Particles in a standing wave of {FREQUENCY:g} Hz and {LEVEL:g} dB, "
        "from rest\nlines: analytic solution, symbols: acousticDEMFoam"
    )
    runTables.save(figure, CASE/"isolatedParticle.png")


def main():
    t, diameters, v = read(CASE)
    v = v/U0
    fits = [fit(t, v[:, i], d) for i, d in enumerate(diameters)]

    print("diameter  entrainment             lag [degrees]")
    print("[um]      computed   theory       computed   theory")
    for d, (eta, phi) in zip(diameters, fits):
        print(
            f"{1e6*d:<8.3g}  {eta:<11.6f}{entrainment(d):<13.6f}"
            f"{np.degrees(phi):<11.4f}{np.degrees(phase(d)):.4f}"
        )

    plot(t, diameters, v, fits)


if __name__ == "__main__":
    main()
