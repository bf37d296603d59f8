"""Colours, fonts and small shapes of all figures of the manual."""

import matplotlib
import matplotlib.pyplot as plt
from matplotlib.patches import FancyBboxPatch
from runTables import COLOURS

BLUE, RED, GREEN, ORANGE, SKY, PINK, GREY, _ = COLOURS
PALE, DARK = "#e8e8e8", "#303030"

WIDTH = 6.4  # inches, of every figure: 10 points are 15 pixels of 700
SMALL = 9.5  # points, the smallest font


def use(name):
    """The settings, from scratch; what is written depends on the name only."""
    plt.close("all")
    matplotlib.rcdefaults()
    matplotlib.use("Agg")
    plt.rcParams.update({
        "svg.hashsalt": name,
        "svg.fonttype": "none",  # texts, not the outlines of their letters
        "path.simplify": True,
        "font.family": "DejaVu Sans",
        "font.size": 10,
        "axes.titlesize": 10,
        "axes.labelsize": 10,
        "xtick.labelsize": SMALL,
        "ytick.labelsize": SMALL,
        "legend.fontsize": SMALL,
        "axes.edgecolor": DARK,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.grid": False,
        "legend.frameon": False,
        "lines.linewidth": 1.8,
        "figure.facecolor": "white",  # readable on a dark page, too
        "savefig.facecolor": "white",
    })


def save(figure, target):
    figure.savefig(
        target, metadata={"Date": None, "Creator": None, "Title": target.stem}
    )
    # No blanks at the ends of lines, which format checks do not like
    lines = target.read_text().splitlines()
    target.write_text("\n".join(line.rstrip() for line in lines) + "\n")


def canvas(height, width=100):
    """A figure without axes, in units of a hundredth of its width."""
    figure = plt.figure(figsize=(WIDTH, WIDTH*height/width))
    axes = figure.add_axes((0, 0, 1, 1))
    axes.set(xlim=(0, width), ylim=(0, height), aspect="equal")
    axes.axis("off")
    return figure, axes


def box(axes, x, y, width, height, text="", colour=GREY, fill="white",
        size=10, weight="normal", **more):
    """A box with its lower left corner at x, y, and a text in its middle."""
    axes.add_patch(FancyBboxPatch(
        (x, y), width, height, boxstyle="round,pad=0,rounding_size=0.9",
        facecolor=fill, edgecolor=colour, linewidth=1.3, zorder=2,
    ))
    axes.text(
        x + width/2, y + height/2, text, ha="center", va="center",
        fontsize=size, weight=weight, zorder=3, **{"linespacing": 1.25, **more}
    )


def arrow(axes, start, end, colour=DARK, style="-|>", **more):
    axes.annotate(
        "", xy=end, xytext=start, zorder=more.pop("zorder", 4),
        arrowprops={
            "arrowstyle": style, "color": colour, "linewidth": 1.4,
            "shrinkA": 0, "shrinkB": 0, "mutation_scale": 12, **more,
        },
    )
