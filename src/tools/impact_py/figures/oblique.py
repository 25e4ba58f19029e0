"""Oblique impacts: restitution and slope of the surface over tan γ, with the geometric
explanation."""

import numpy as np
from matplotlib.lines import Line2D

from ..style import (BLACK, BLUE, GREEN, GREY, MARKERS, ORANGE, PURPLE, SKY, TWO_COLUMNS,
                     VERMILION, label_panel, legend_beside, letter, marker_style, panels, save_both)
from ..tables import read_table

COLOURS = (BLACK, GREEN, SKY, BLUE, VERMILION, ORANGE, PURPLE)
STIFFEST = 1  # walls that are as stiff as the disk or more, M c²/R²


def walls_of(table):
    """The walls and velocities in the order of the table, each with its colour and marker."""
    walls = dict.fromkeys(zip(table["wall_k_a"], table["velocity"]))
    return list(zip(walls, COLOURS, MARKERS))


def on_wall(table, wall):
    """The rows of a wall and velocity."""
    return table.where("wall_k_a", wall[0]).where("velocity", wall[1])


def answered(table):
    """Of walls_of(): those with means, and those without any."""
    walls = walls_of(table)
    there = [np.isfinite(on_wall(table, wall)["restitution"]).any() for wall, _, _ in walls]
    return ([wall for wall, is_there in zip(walls, there) if is_there],
            [wall for (wall, _, _), is_there in zip(walls, there) if not is_there])


def draw_means(ax, curve, column, colour, marker):
    """Means with their standard errors; hollow where lattices were refused."""
    x, y, error = curve["tan_gamma"], curve[column], np.nan_to_num(curve[column + "_error"])
    ax.errorbar(x, y, error, linestyle="", elinewidth=0.7, capsize=1.5, color=colour)
    for refused in (False, True):
        chosen = (curve["refused"] > 0) == refused
        ax.plot(x[chosen], y[chosen], **marker_style(colour, marker, not refused))


def draw_line(ax, curve, values, colour, line):
    """What the means are compared with."""
    ax.plot(curve["tan_gamma"], values, line, color=colour, linewidth=0.7)


def draw_single(ax, impacts):
    """What sliding changes in single impacts on stiff walls, over what the slope explains."""
    largest = 0
    for wall, colour, marker in walls_of(impacts):
        if wall[0] < STIFFEST:
            continue
        rows = on_wall(impacts, wall)
        explained = rows["on_slope"] - rows["straight"]
        ax.plot(explained, rows["gain"], **{**marker_style(colour, marker), "markersize": 2.5})
        largest = max(largest, np.max(np.abs(explained), initial=0))
    ax.plot([-largest, largest], [-largest, largest], color=GREY, linewidth=0.6, zorder=0)
    ax.set_xlabel("$e - e_0$ by the slope")
    ax.set_ylabel("$e - e_0$")
    label_panel(ax, "single impacts on stiff walls", 0.04, 0.93)


def legend(walls, refused, is_partial):
    """The legend's entries of walls and lines."""
    entries = [Line2D([], [], label=rf"$k_a = {wall[0]:g}$, ${wall[1]:g}\,c$",
                      **marker_style(colour, marker)) for wall, colour, marker in walls]
    entries += [Line2D([], [], label=rf"${wall[0]:g}$, ${wall[1]:g}\,c$: all refused", linestyle="")
                for wall in refused]
    if is_partial:
        entries.append(Line2D([], [], label="some lattices refused",
                              **marker_style(GREY, "o", False)))
    lines = (("--", "(a) straight, $v\\,\\cos\\gamma$"), (":", "(b) chord of the contact"),
             ("-", "(c) by the slope"), (":", "(c) by the chord"))
    return entries + [Line2D([], [], color=GREY, linestyle=line, linewidth=0.8, label=label)
                      for line, label in lines]


def figure_oblique(folder):
    """e over tan γ; the slope of the surface; what sliding changes, and what of it the slope
    explains."""
    table = read_table(folder / "oblique.csv")
    impacts = read_table(folder / "oblique_impacts.csv")
    figure, axes = panels(TWO_COLUMNS, 0.66 * TWO_COLUMNS, rows=2, columns=2)
    (above, slopes), (gains, single) = axes
    walls, refused = answered(table)
    for wall, colour, marker in walls:
        curve = on_wall(table, wall)
        draw_means(above, curve, "restitution", colour, marker)
        draw_line(above, curve, curve["straight"], colour, "--")
        draw_means(slopes, curve, "slope", colour, marker)
        draw_line(slopes, curve, curve["chord"], colour, ":")
        draw_means(gains, curve, "gain", colour, marker)
        draw_line(gains, curve, curve["on_slope"] - curve["straight"], colour, "-")
        draw_line(gains, curve, curve["on_chord"] - curve["straight"], colour, ":")
    draw_single(single, impacts)
    for ax, label in ((above, "$e$"), (slopes, "$\\tan\\alpha$"), (gains, "$e - e_0$")):
        ax.set_xlabel("$\\tan\\gamma$")
        ax.set_ylabel(label)
    above.axhline(1, color=GREY, linewidth=0.6, zorder=0)
    for ax in (slopes, gains):
        ax.axhline(0, color=GREY, linewidth=0.6, zorder=0)
    is_partial = np.any((table["refused"] > 0) & np.isfinite(table["restitution"]))
    letter(axes.flat)
    legend_beside(slopes, legend(walls, refused, is_partial))
    save_both(figure, folder, "oblique")
