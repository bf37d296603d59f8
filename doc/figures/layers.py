"""The layers of the program; an arrow points to what a layer knows.

Folders are drawn as they are in src; what they hold is said here.
"""

from pathlib import Path

import style

SOURCE = Path(__file__).resolve().parents[2]/"src"

HOLDS = {
    # src/aerosol
    "aerosolCloud": "composes, evolves",
    "timeStepping": "order of the moves",
    "motion": "exact step, wakes",
    "laws": "drag, wake, contact",
    "collisions": "clusters, contacts",
    "turbulence": "eddies",
    "coupling": "force on the gas",
    "domain": "box, its frame",
    "particles": "arrays of all",
    "initial": "sources of particles",
    "neighbours": "lists, Verlet skin",
    "parallel": "ranks, ghosts",
    # src/acoustics
    "meshSound": "sound on a mesh",
    "sampling": "from cells to points",
    "compressible": "implicit",
    "explicitCompressible": "explicit",
    "replay": "a period, again",
    "analytic": "formulas",
    "sources": "piston, pressure",
    "levelControl": "the wanted level",
    "harmonics": "mean, amplitudes",
}
COLUMNS = 4


def folders(library, order=()):
    """The folders of a library: those that are named first, then the others."""
    there = {
        path.name for path in (SOURCE/library).iterdir()
        if path.is_dir() and path.name not in ("Make", "lnInclude")
    }
    first = [name for name in order if name in there]
    return first + sorted(there - set(first))


def layer(axes, top, width, library, names, colour):
    """A library, with its folders in rows; returns where it ends."""
    rows = -(-len(names)//COLUMNS)
    height = 6 + 7.6*rows
    style.box(axes, 1, top - height, width, height, colour=colour)
    axes.text(3, top - 3.3, f"src/{library}", weight="bold", va="center",
              color=colour, zorder=3)
    for k, name in enumerate(names):
        x = 3 + 0.247*width*(k % COLUMNS)
        y = top - 8.4 - 7.6*(k//COLUMNS)
        axes.text(x, y, name, va="center", fontsize=style.SMALL, zorder=3,
                  gid=f"src/{library}/{name}")
        axes.text(x, y - 2.9, HOLDS.get(name, ""), va="center",
                  fontsize=style.SMALL, color="#606060", zorder=3)
    return top - height


def figure():
    upper = folders("aerosol", (
        "aerosolCloud", "timeStepping", "collisions", "motion", "laws",
        "neighbours", "parallel", "domain",
    ))
    lower = [
        name for name in folders("acoustics", ("analytic", "replay"))
        if name != "soundField"
    ]
    rows = -(-len(upper)//COLUMNS) + -(-len(lower)//COLUMNS)
    height = 58 + 7.6*rows
    picture, axes = style.canvas(height)

    y = height - 8
    style.box(
        axes, 1, y, 98, 7, "applications/solvers/acousticDEMFoam: the loop",
        colour=style.DARK, fill=style.PALE,
    )
    style.arrow(axes, (50, y), (50, y - 5))
    bottom = layer(axes, y - 5, 92, "aerosol", upper, style.BLUE)

    middle = bottom - 6.5
    style.box(
        axes, 30, middle - 8, 40, 8,
        "soundField\ngas velocity at points and times", colour=style.RED,
        fill="#fdeee4", size=style.SMALL,
    )
    style.arrow(axes, (50, bottom), (50, middle))
    axes.plot((96.5, 96.5), (y, middle - 2.2), color=style.DARK, lw=1.4)
    style.arrow(axes, (96.5, middle - 2.2), (70, middle - 2.2))
    axes.text(
        72.5, middle - 6.6, "an arrow points to\nwhat a layer knows",
        va="center", fontsize=style.SMALL, linespacing=1.3,
    )
    style.box(
        axes, 1, middle - 8, 25, 8, "src/functionObjects\nlevel, amplitudes",
        colour=style.PINK, size=style.SMALL,
    )
    low = middle - 8 - 6.5
    style.arrow(axes, (50, low), (50, middle - 8))
    style.arrow(axes, (13.5, middle - 8), (13.5, low))
    end = layer(axes, low, 98, "acoustics", lower, style.GREEN)

    style.box(
        axes, 1, end - 11, 98, 7,
        "src/common: dictionaries, restart, versions of OpenFOAM",
        colour=style.DARK, fill=style.PALE,
    )
    style.arrow(axes, (50, end), (50, end - 4))
    axes.set_ylim(end - 12, height)
    picture.set_size_inches(style.WIDTH, style.WIDTH*(height - end + 12)/100)
    return picture
