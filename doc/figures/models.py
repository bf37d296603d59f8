"""Which model matters for which size, frequency and level (doc/howTo/models.md).

By itself it prints the table of that page.
"""

import sys
from pathlib import Path

if __name__ == "__main__":
    sys.path.append(str(Path(__file__).resolve().parents[2]/"bin"))
    import runTables  # noqa: F401  finds a Python that has what follows

import air
import numpy as np

BOLTZMANN, TEMPERATURE = 1.380649e-23, 293.15  # J/K, K
UNSTEADY = 0.05  # radius over Stokes layer from which on unsteady drag matters
LEVELS = 140.0, 147.0, 155.0  # dB
SIZES = 0.5e-6, 1e-6, 2e-6, 5e-6, 10e-6, 20e-6  # m
FREQUENCY, LEVEL = 1400.0, 147.0  # Hz, dB: of the table


def stokes_layer(frequency):
    """Thickness [m]"""
    return np.sqrt(air.NU/(np.pi*frequency))


def slip_amplitude(d, frequency, level):
    """Of the gas relative to the particle, as a displacement [m]."""
    omega = 2*np.pi*frequency
    slip = np.abs(1 - air.response(omega, d))
    return slip*air.velocity_amplitude(level)/omega


def straying(d, time):
    """Root mean square of the distance of two Brownian particles [m], in one
    direction."""
    mass = np.pi/6*air.FLY_ASH*d**3
    diffusion = BOLTZMANN*TEMPERATURE*air.relaxation_time(d)/mass
    return np.sqrt(4*diffusion*time)


def rows(sizes=SIZES, frequency=FREQUENCY, level=LEVEL):
    """Of the table: diameter, and what is compared."""
    for d in sizes:
        slip = slip_amplitude(d, frequency, level)/stokes_layer(frequency)
        radius = 0.5*d/stokes_layer(frequency)
        stray = straying(d, 1/frequency)/d
        yield [
            f"{1e6*d:g} um",
            f"{2*np.pi*frequency*air.relaxation_time(d):.2g}",
            f"{slip:.2g}",
            "`history`" if slip > 1 else "`memory`",
            f"{radius:.2g}",
            "`Basset`" if radius > UNSTEADY else "none",
            f"{stray:.1g}",
            f"{1e3*air.GRAVITY*air.relaxation_time(d):.2g} mm/s",
        ]


def crossing(function, frequencies, level=1.0):
    """Diameters [m] at which a function of diameter and frequency has a value."""
    sizes = np.logspace(-7.5, -4, 700)
    found = []
    for frequency in frequencies:
        above = function(sizes, frequency) > level
        change = np.nonzero(above[1:] != above[:-1])[0]
        found.append(sizes[change[0]] if change.size else np.nan)
    return np.array(found)


def figure():
    import matplotlib.pyplot as plt
    import style

    picture = plt.figure(figsize=(style.WIDTH, 4.6))
    axes = picture.add_axes((0.11, 0.115, 0.865, 0.865))
    frequencies = np.logspace(2, 4.35, 60)

    for level, line in zip(LEVELS, (":", "-", "--")):
        sizes = 1e6*crossing(
            lambda d, f, level=level: slip_amplitude(d, f, level)
            / stokes_layer(f), frequencies)
        axes.plot(frequencies, sizes, color=style.RED, ls=line,
                  label=f"slip of a Stokes layer, {level:g} dB")
    axes.plot(
        frequencies, 1e6*crossing(lambda d, f: 0.5*d/stokes_layer(f),
                                  frequencies, UNSTEADY),
        color=style.GREEN, label="radius of 1/20 Stokes layer")
    axes.plot(
        frequencies, 1e6*crossing(
            lambda d, f: 2*np.pi*f*air.relaxation_time(d), frequencies),
        color=style.BLUE, label=r"$\omega\tau = 1$")
    axes.plot(
        frequencies, 1e6*crossing(lambda d, f: -straying(d, 1/f)/d, frequencies,
                                  -1),
        color=style.ORANGE, label="strays by its diameter in a period")

    axes.set(xscale="log", yscale="log", xlim=(100, 2e4), ylim=(0.1, 100),
             xlabel="frequency [Hz]", ylabel="diameter [µm]",
             yticks=(0.1, 0.3, 1, 3, 10, 30, 100))
    axes.set_xticks([100, 200, 500, 1000, 2000, 5000, 10000, 20000],
                    ["100", "200", "500", "1k", "2k", "5k", "10k", "20k"])
    axes.yaxis.set_major_formatter("{x:g}")
    axes.minorticks_off()
    axes.legend(loc="upper right", ncol=2, columnspacing=1.2)
    for place, text, colour in (
        ((112, 29), "above: unsteady drag", style.GREEN),
        ((3300, 0.6), "above: wake history,\nbelow: memory", style.RED),
        ((112, 0.5), "below: Brownian motion", style.ORANGE),
    ):
        axes.text(*place, text, color=colour, va="center")
    return picture


if __name__ == "__main__":
    for row in rows():
        print("| " + " | ".join(row) + " |")
