"""The steps of the three strategies on a time axis."""

import air
import numpy as np
import style

FREQUENCY, LEVEL, STEPS = 1400.0, 147.0, 50  # Hz, dB, fluid steps per period
SMALLEST, KP, KC = 0.5e-6, 0.5, 0.1  # m; factors of multipleTimeStep

LEFT, STEP = 29, 32.5  # where the axis begins, and the length of a fluid step


def ticks(axes, y, times, colour, height=2.2):
    """Marks at times in fluid steps, on a line."""
    x = LEFT + STEP*np.asarray(times)
    axes.vlines(x, y - height/2, y + height/2, color=colour, lw=1.2, zorder=3)


def note(axes, x, y, text):
    axes.text(
        x, y, text, ha="center", va="center", fontsize=style.SMALL,
        bbox={"facecolor": "white", "edgecolor": "none", "pad": 1},
    )


def lane(axes, y, label):
    axes.plot((LEFT, LEFT + 2*STEP), (y, y), color=style.DARK, lw=0.8)
    axes.text(LEFT - 1.5, y, label, ha="right", va="center",
              fontsize=style.SMALL)


def strategy(axes, y, name, what):
    axes.text(1, y + 5, name, weight="bold", va="center")
    axes.text(LEFT, y + 5, what, va="center", fontsize=style.SMALL,
              bbox={"facecolor": "white", "edgecolor": "none", "pad": 1})


def figure():
    picture, axes = style.canvas(84)
    fluid, particle, collision = style.BLUE, style.GREEN, style.RED

    for k, label in enumerate(("$t$", r"$t+\Delta t_f$", r"$t+2\Delta t_f$")):
        x = LEFT + k*STEP
        axes.plot((x, x), (10.5, 80), color=style.GREY, lw=0.8, ls=":")
        axes.text(x - 0.5*(k > 1), 81.8, label, ha="center", va="center")

    fine = np.linspace(0, 2, 101)
    medium = np.linspace(0, 2, 11)

    y = 72
    strategy(axes, y, "conventional", "all at the collision step")
    for row, (label, colour) in enumerate((
        ("gas, neighbours", fluid), ("motion, wakes", particle),
        ("contacts", collision),
    )):
        lane(axes, y - 3.5*row, label)
        ticks(axes, y - 3.5*row, fine, colour)

    y = 49
    strategy(axes, y, "multipleTimeStep", "each task at its own step")
    lane(axes, y, r"fluid step $\Delta t_f$")
    ticks(axes, y, (0, 1, 2), fluid)
    lane(axes, y - 3.5, r"particle step $\Delta t_p$")
    ticks(axes, y - 3.5, medium, particle)
    lane(axes, y - 7, r"collision step $\Delta t_c$")
    for k in (2, 7):
        axes.axvspan(
            LEFT + STEP*medium[k], LEFT + STEP*medium[k + 1],
            (y - 8.6)/84, (y - 5.4)/84, color=style.PALE, lw=0,
        )
        ticks(axes, y - 7, np.linspace(medium[k], medium[k + 1], 11), collision)
    note(axes, LEFT + STEP, y - 10.6, "only for pairs that may meet")

    y = 25
    strategy(axes, y, "eventDriven", "one step for all, contacts in between")
    lane(axes, y, "all particles")
    ticks(axes, y, (0, 1, 2), fluid)
    lane(axes, y - 4, "a cluster")
    ends = (0, 0.26, 0.42, 0.51, 0.56)
    contact = 0.62
    ticks(axes, y - 4, ends, particle)
    ticks(axes, y - 4, (0.8, 1), particle)
    axes.plot(LEFT + STEP*contact, y - 4, "*", color=collision, ms=13, zorder=5)
    note(axes, LEFT + STEP*contact, y - 7.8, "first contact, at its own time")
    axes.plot((LEFT + STEP, LEFT + 2*STEP), (y - 4, y - 4), color="white",
              lw=2, zorder=2)

    style.arrow(axes, (LEFT, 11), (98.5, 11))
    axes.text(98.5, 13.2, "time", ha="right", va="center")

    period = 1/FREQUENCY
    speed = 2*air.velocity_amplitude(LEVEL)
    steps = (
        period/STEPS, KP*air.relaxation_time(SMALLEST), KC*SMALLEST/speed,
    )
    axes.text(
        50, 4.6,
        f"At {FREQUENCY:g} Hz, {LEVEL:g} dB, from {1e6*SMALLEST:g} µm on:"
        rf"  $\Delta t_f = T/{STEPS}$ = {1e6*steps[0]:.0f} µs,"
        "\n"
        rf"$\Delta t_p = {KP:g}\,\tau$ = {1e6*steps[1]:.1f} µs,  "
        rf"$\Delta t_c = {KC:g}\,d_{{min}}/u_c$ = {1e9*steps[2]:.0f} ns"
        " (drawn longer)",
        ha="center", va="center", fontsize=style.SMALL, linespacing=1.5,
    )
    return picture
