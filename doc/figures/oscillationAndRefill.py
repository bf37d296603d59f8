"""A coarse and a fine particle in sound; the swept path, and its refill."""

import air
import matplotlib.pyplot as plt
import numpy as np
import style
from matplotlib.patches import FancyBboxPatch

FREQUENCY, LEVEL = 1400.0, 147.0  # Hz, dB
FINE, COARSE = 1e-6, 5e-6  # m


def displacement(amplitude, phase):
    """Real part of a phasor at phases of the sound."""
    return np.real(amplitude*np.exp(1j*phase))


def sketch(axes, title, swept, moved):
    """The path of a coarse particle in the frame of the fine ones."""
    axes.set(xlim=(-9.6, 9.6), ylim=(-5.2, 4.2), aspect="equal")
    axes.axis("off")
    axes.set_title(title, pad=3)
    now = -2.1 if moved else 0
    for y, colour in {0: style.SKY, **({now: style.ORANGE} if moved else {})
                      }.items():
        axes.add_patch(FancyBboxPatch(
            (-7, y - 0.95), 14, 1.9, facecolor=colour, alpha=0.35,
            boxstyle="round,pad=0,rounding_size=0.9", edgecolor=colour,
        ))

    # Fine particles; those on a path that was swept are gone
    places = np.random.RandomState(3).uniform((-9.5, -5), (9.5, 4), (66, 2))

    def on(y):
        return (np.abs(places[:, 1] - y) < 0.95) & (np.abs(places[:, 0]) < 7)

    left = ~on(0) if swept else np.full(len(places), True)
    for chosen, colour in (
        (left & ~on(now), style.GREY), (left & on(now), style.RED)
    ):
        axes.scatter(*places[chosen].T, s=11, color=colour, lw=0)
    axes.scatter(0, now, s=150, color=style.BLUE, lw=0, zorder=3)
    for way in (-1, 1):
        style.arrow(axes, (1.2*way, now), (6.8*way, now), style.BLUE)
    if moved:
        style.arrow(axes, (-8.3, 0.1), (-8.3, now - 0.1))


def figure():
    omega = 2*np.pi*FREQUENCY
    gas = 1e6*air.velocity_amplitude(LEVEL)/omega
    fine, coarse = (gas*air.response(omega, d) for d in (FINE, COARSE))
    relative = abs(fine - coarse)

    picture = plt.figure(figsize=(style.WIDTH, 5.2))
    axes = picture.add_axes((0.115, 0.47, 0.86, 0.51))
    periods = np.linspace(0, 1.5, 301)
    phase = 2*np.pi*periods - np.pi/2
    paths = [displacement(a, phase) for a in (gas, fine, coarse)]
    axes.fill_between(periods, paths[1], paths[2], color=style.PALE, lw=0)
    for path, colour, line, text in (
        (paths[0], style.GREY, "--", f"gas, {gas:.0f} µm"),
        (paths[1], style.RED, "-",
         f"fine, {1e6*FINE:g} µm: {abs(fine):.0f} µm"),
        (paths[2], style.BLUE, "-",
         f"coarse, {1e6*COARSE:g} µm: {abs(coarse):.0f} µm"),
    ):
        axes.plot(periods, path, color=colour, ls=line, label=text)
    k = 200 + np.argmax(np.abs(paths[1] - paths[2])[200:])
    axes.annotate(
        "", xy=(periods[k], paths[1][k]), xytext=(periods[k], paths[2][k]),
        arrowprops={"arrowstyle": "<->", "color": style.DARK, "lw": 1.2,
                    "shrinkA": 0, "shrinkB": 0},
    )
    axes.text(periods[k] + 0.015, 106,
              f"relative:\n{relative:.0f} µm", va="center")
    axes.set(
        xlim=(0, 1.5), ylim=(-195, 290), xlabel="time [periods]",
        ylabel="displacement [µm]", yticks=(-200, -100, 0, 100, 200),
        xticks=(0, 0.5, 1, 1.5),
    )
    axes.legend(
        title=f"Oscillation amplitudes at {FREQUENCY:g} Hz and {LEVEL:g} dB",
        ncol=3, loc="upper center", columnspacing=1.2, handlelength=1.6,
        title_fontsize=10, borderaxespad=0,
    )

    for k, (title, swept, moved) in enumerate((
        ("first period:\npartners on the path", False, False),
        ("later periods:\nthe path is swept", True, False),
        ("refill: the path\nmoves sideways", True, True),
    )):
        sketch(
            picture.add_axes((0.005 + 0.333*k, 0.06, 0.323, 0.23)),
            title, swept, moved,
        )

    sink = 1e6*air.GRAVITY*(
        air.relaxation_time(COARSE) - air.relaxation_time(FINE)
    )/FREQUENCY
    picture.text(
        0.5, 0.012, "In the frame of the fine particles. Settling shifts the "
        f"path, {1e6*(FINE + COARSE):g} µm wide, by {sink:.1f} µm per period.",
        ha="center", va="bottom", fontsize=style.SMALL,
    )
    return picture
