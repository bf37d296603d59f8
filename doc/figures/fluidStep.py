"""A particle's way through one fluid step h of `eventDriven`."""

import style

WIDTH, RIGHT = 57, 34  # of the boxes of the left and the right column
HEIGHT, GAP = 7.8, 3.4
ROWS = 9


def row(k):
    """The height of the middle of a row, counted from the top."""
    return (ROWS - k - 1)*(HEIGHT + GAP) + 0.5*HEIGHT + 1


def main_box(axes, k, text, colour, **more):
    style.box(axes, 1, row(k) - HEIGHT/2, WIDTH, HEIGHT, text, colour, **more)


def side_box(axes, k, text, colour):
    style.box(
        axes, 99 - RIGHT, row(k) - HEIGHT/2, RIGHT, HEIGHT, text, colour
    )


def figure():
    picture, axes = style.canvas(ROWS*(HEIGHT + GAP) - GAP + 2)
    left, right = 1 + WIDTH/2, 99 - RIGHT/2

    main_box(axes, 0, "gas advanced to $t + h$", style.RED)
    main_box(axes, 1, "has any particle left its Verlet skin?", style.ORANGE,
             fill="#fdf3df")
    main_box(axes, 2, "gas velocity sampled at the particle,\n"
             "at $t$, $t + h/2$ and $t + h$", style.RED)
    main_box(axes, 3, "trajectory without wakes:\ndrag, gravity, noise",
             style.GREEN)
    main_box(axes, 4, "trajectory in the wakes of neighbours:\n"
             "prediction and correction", style.GREEN)
    main_box(axes, 5, "does another trajectory come closer\n"
             "than five contact distances?", style.ORANGE, fill="#fdf3df")
    main_box(axes, 7, "position and velocity at $t + h$", style.GREEN)
    main_box(axes, 8, "breakage, force on the gas, tables", style.DARK)
    for upper, lower in ((0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (5, 7),
                         (7, 8)):
        style.arrow(axes, (left, row(upper) - HEIGHT/2),
                    (left, row(lower) + HEIGHT/2))

    side_box(axes, 1, "wrap, migrate, ghosts,\nnew neighbour lists", style.BLUE)
    side_box(axes, 5, "cluster gathered\non one rank", style.BLUE)
    side_box(axes, 6, "short steps to the next\ncontact, or to $t + h$",
             style.GREEN)
    side_box(axes, 7, "merge or bounce", style.ORANGE)
    for k in (1, 5):
        style.arrow(axes, (1 + WIDTH, row(k)), (99 - RIGHT, row(k)))
        axes.text(61.5, row(k) + 1.6, "yes", ha="center", va="center",
                  fontsize=style.SMALL)
    style.arrow(axes, (right, row(1) - HEIGHT/2), (right, row(2)), style="-")
    style.arrow(axes, (right, row(2)), (1 + WIDTH, row(2)))
    axes.text(left + 1.5, row(6), "no", va="center", fontsize=style.SMALL)

    style.arrow(axes, (right, row(5) - HEIGHT/2), (right, row(6) + HEIGHT/2))
    style.arrow(axes, (right - 6, row(6) - HEIGHT/2),
                (right - 6, row(7) + HEIGHT/2))
    style.arrow(axes, (right + 6, row(7) + HEIGHT/2),
                (right + 6, row(6) - HEIGHT/2))
    axes.text(right + 7.5, 0.5*(row(6) + row(7)), "go on", va="center",
              fontsize=style.SMALL)
    style.arrow(axes, (99 - RIGHT, row(7)), (1 + WIDTH, row(7)))
    return picture
