"""Figure 6: restitution on the elastic wall."""

import numpy as np
from matplotlib.lines import Line2D

from ..style import (BLACK, BLUE, GREEN, ORANGE, PURPLE, SKY, TWO_COLUMNS, VERMILION, letter,
                     marker_style, panels, save_both)
from ..tables import read_table
from .axes import sound_speed_axis, speed_axis

UNIFORM = "reset 0.004 uniform placement"
# Case, label, colour, marker, filled.
BOUNDARIES = (
    ("fixed", "fixed", BLACK, "v", True),
    ("reset 0.001", "reset every $0.001\\,R/c$", GREEN, "D", True),
    ("reset 0.002", "reset every $0.002\\,R/c$", SKY, "s", True),
    ("reset 0.004", "reset every $0.004\\,R/c$", BLUE, "o", True),
    (UNIFORM, "the same, uniform placement", BLUE, "o", False),
    ("reset 0.008", "reset every $0.008\\,R/c$", ORANGE, "^", True),
    ("reset 0.016", "reset every $0.016\\,R/c$", PURPLE, "X", True),
    ("viscous", "viscous", VERMILION, "P", True),
)


def draw_laws(ax, table, fits):
    """Eq. (5) with the fit of the paper's boundary, and the paper's own; the two lines."""
    curve = table.where("case", "reset 0.004")
    fit = fits.where("case", "reset 0.004").first_row()
    label = f"fit of eq. (5): $d_1 = {fit['d1']:.3f}$, $d_2 = {fit['d2']:.3f}$"
    ours = ax.plot(curve["velocity"], curve["fit"], color=BLUE, label=label)
    label = "the paper's fit: $d_1 = 0.973$, $d_2 = 0.119$"
    paper = ax.plot(curve["velocity"], curve["paper_fit"], ":", color=BLACK, label=label)
    return ours + paper


def legend_below(ax, handles, columns):
    """A legend under a panel."""
    ax.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, -0.18), ncol=columns)


def figure6(folder):
    """1 − e against speed for all boundaries; e of the paper's boundary."""
    table = read_table(folder / "figure6.csv")
    figure, (axes,) = panels(TWO_COLUMNS, 0.56 * TWO_COLUMNS, columns=2)
    handles = []
    of_paper = []
    for case, label, *style in BOUNDARIES:
        curve = table.where("case", case)
        handle = Line2D([], [], label=label, **marker_style(*style))
        if case.startswith("reset 0.004"):
            v, e, error = (curve[key] for key in ("velocity", "restitution", "restitution_error"))
            axes[1].errorbar(v, e, np.nan_to_num(error), elinewidth=0.7, capsize=1.5,
                             **marker_style(*style))
            of_paper.append(handle)
        if case != UNIFORM:
            line = {**marker_style(*style), "linestyle": "-", "linewidth": 0.5}
            axes[0].plot(curve["velocity"], 1 - curve["restitution"], **line)
            handles.append(handle)
    of_paper += draw_laws(axes[1], table, read_table(folder / "figure6_fits.csv"))
    for ax in axes:
        speed_axis(ax)
        ax.set_xlabel("$v/c$")
        sound_speed_axis(ax, table)
    axes[0].set_yscale("log")
    axes[0].set_ylabel("$1 - e$")
    axes[1].set_ylabel("$e$")
    letter(axes)
    legend_below(axes[0], handles, 2)
    legend_below(axes[1], of_paper, 1)
    save_both(figure, folder, "figure6")
