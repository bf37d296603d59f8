"""Two trajectories in a fluid step, the contact on them, and what becomes."""

import numpy as np
import style
from matplotlib.patches import Circle

# Positions and displacements per step of two spheres, at both ends of the step
A = {"x": ((9, 46), (82, 22)), "v": ((70, 4), (72, -46)), "r": 6.0}
B = {"x": ((10, 13), (80, 43)), "v": ((72, 0), (66, 56)), "r": 4.0}


def cubic(p, s):
    """The path of Hermite: positions and velocities at both ends are kept."""
    s = np.asarray(s)[..., None]
    (x0, x1), (v0, v1) = np.array(p["x"], float), np.array(p["v"], float)
    return (
        (2*s**3 - 3*s**2 + 1)*x0 + (s**3 - 2*s**2 + s)*v0
        + (3*s**2 - 2*s**3)*x1 + (s**3 - s**2)*v1
    )


def velocity(p, s, ds=1e-6):
    return (cubic(p, s + ds) - cubic(p, s - ds))/(2*ds)


def first_contact():
    """When the centres are closer than the sum of the radii, in steps."""
    s = np.linspace(0, 1, 100001)
    gap = np.linalg.norm(cubic(A, s) - cubic(B, s), axis=1) - A["r"] - B["r"]
    return s[np.argmax(gap < 0)]


def sphere(axes, centre, radius, colour, alpha=1.0, line="-"):
    axes.add_patch(Circle(
        centre, radius, facecolor="white", edgecolor="none", zorder=2.4,
    ))
    axes.add_patch(Circle(
        centre, radius, facecolor=colour, edgecolor=colour, alpha=alpha,
        ls=line, zorder=2.5,
    ))


def figure():
    picture, axes = style.canvas(58)
    when = first_contact()
    blue, red, green = style.BLUE, style.ORANGE, style.GREEN

    for p, colour in ((A, blue), (B, red)):
        before = cubic(p, np.linspace(0, when, 60))
        after = cubic(p, np.linspace(when, 1, 40))
        axes.plot(*before.T, color=colour)
        axes.plot(*after.T, color=colour, ls=(0, (1, 2)), lw=1.4)
        sphere(axes, cubic(p, 0.0), p["r"], colour, 0.9)
        sphere(axes, cubic(p, 0.45*when), p["r"], colour, 0.25)
        sphere(axes, cubic(p, when), p["r"], colour, 0.9)

    # Volume, mass and momentum are kept
    masses = np.array([A["r"]**3, B["r"]**3])
    centre, speed = (
        (masses[0]*value(A, when) + masses[1]*value(B, when))/masses.sum()
        for value in (cubic, velocity)
    )
    radius = masses.sum()**(1/3)
    end = centre + speed*(1 - when)
    axes.plot(*np.array([centre, end]).T, color=green)
    sphere(axes, end, radius, green, 0.9)

    touch = cubic(A, when) + A["r"]/(A["r"] + B["r"])*(
        cubic(B, when) - cubic(A, when)
    )
    axes.plot(*touch, "*", color=style.DARK, ms=14, zorder=5)
    small = {"ha": "center", "va": "center", "fontsize": style.SMALL,
             "zorder": 6}
    axes.annotate(
        r"contact at $t_c$:" "\n" r"$|\mathbf{x}_1-\mathbf{x}_2| = a_1+a_2$",
        xy=touch, xytext=(31, 31), ha="center", va="center",
        arrowprops={"arrowstyle": "-", "color": style.GREY, "lw": 1,
                    "shrinkB": 6},
    )
    axes.text(*(cubic(A, 0.0) + (0, 9)), "$t$", **small)
    axes.text(*(cubic(B, 0.0) - (0, 7)), "$t$", **small)
    axes.text(end[0], end[1] + radius + 2.5, r"$t+\Delta t_f$", **small)
    axes.text(
        end[0], end[1] - radius - 5.5,
        "merged particle:\nsum of volumes,\nmasses and momenta", **small,
        linespacing=1.3,
    )
    axes.text(74, 50, "without the contact:\ndotted", **small)
    return picture
