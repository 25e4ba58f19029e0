"""Figure 3: restitution on the potential wall, dissipation time, contact duration."""

from itertools import cycle

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import MultipleLocator

from ..program import InputError
from ..style import (BLACK, BLUE, GREY, MARKERS, ONE_COLUMN, ORANGE, SKY, TWO_COLUMNS, VERMILION,
                     label_panel, legend_beside, letter, marker_style, panels, plt, save_both,
                     ticks)
from ..tables import read_table
from .axes import draw_restitution, sound_speed_axis, speed_axis


def damping_styles(table):
    """A colour and a marker for each η*."""
    etas = np.unique(table["eta"])
    colours = plt.cm.viridis(np.linspace(0, 0.87, len(etas)))
    return dict(zip(etas, zip(colours, cycle(MARKERS))))


def damping_handles(styles):
    """The legend's entries of η*."""
    return [
        Line2D([], [], label=rf"$\eta^* = {eta:g}$", **marker_style(*style))
        for eta, style in styles.items()
    ]


def draw_loss(ax, table, styles):
    """1 − e against speed for each η*, with theory."""
    for eta, style in styles.items():
        curve = table.where("eta", eta)
        if eta > 0:
            ax.plot(curve["velocity"], 1 - curve["ode"], "--", color=style[0], linewidth=0.8)
        draw_restitution(ax, curve, lambda e: 1 - e, *style)
    ax.set_yscale("log")
    ax.set_ylim(1e-4, 0.9)


def draw_values(ax, table, styles):
    """e itself, with the fit of eq. (5)."""
    for eta, style in styles.items():
        curve = table.where("eta", eta)
        ax.plot(curve["velocity"], curve["fit"], color=style[0], linewidth=0.8)
        draw_restitution(ax, curve, lambda e: e, *style)


def say_what_is_missing(ax, table, styles):
    """Names the η* that were not simulated on this wall."""
    missing = [f"{eta:g}" for eta in styles if len(table.where("eta", eta)["eta"]) == 0]
    if missing:
        listed = ", ".join(missing[:-1]) + " and " * (len(missing) > 1) + missing[-1]
        label_panel(ax, rf"$\eta^* =$ {listed}: not simulated", 0.04, 0.055)


def damping_legend(styles):
    """The legend's entries of η* and of the two kinds of lines."""
    lines = (("--", r"eq. (4), measured $\tau_0$"), ("-", "fit of eq. (5)"))
    return damping_handles(styles) + [
        Line2D([], [], color=GREY, linestyle=style, linewidth=0.8, label=label)
        for style, label in lines
    ]


def figure3(folder):
    """Restitution against speed on both walls; dissipation time; contact duration."""
    table = read_table(folder / "figure3.csv")
    walls = np.unique(table["wall_a"])
    styles = damping_styles(table)
    figure, axes = panels(
        TWO_COLUMNS, 0.8 * TWO_COLUMNS, rows=2, columns=len(walls), sharex=True, sharey="row",
        gridspec_kw={"height_ratios": (1.7, 1)},
    )
    for (above, below), wall in zip(axes.T, walls):
        on_wall = table.where("wall_a", wall)
        draw_loss(above, on_wall, styles)
        draw_values(below, on_wall, styles)
        speed_axis(above)
        sound_speed_axis(above, table)
        label_panel(above, f"$a = {wall:g}/R$", 0.04, 0.96)
        say_what_is_missing(above, on_wall, styles)
        below.set_xlabel("$v/c$")
    axes[0, 0].set_ylabel("$1 - e$")
    axes[1, 0].set_ylabel("$e$")
    letter(axes.flat)
    legend_beside(axes[0, -1], damping_legend(styles))
    save_both(figure, folder, "figure3")
    figure3_dissipation(folder, table)
    figure3_duration(folder, table)
    figure3_losses(folder)


DISSIPATION = "dissipation_time_by_eta_by_k_a"


def figure3_dissipation(folder, table):
    """The dissipation time against speed: of the weakest damping that both walls have, in units of
    the bonds' own; of the others, over that."""
    styles = damping_styles(table)
    walls = np.unique(table["wall_a"])
    damped = [set(table.where("wall_a", wall)["eta"]) - {0.0} for wall in walls]
    weakest = min(set.intersection(*damped), default=None)
    if weakest is None:
        raise InputError(f"{table.path}: has no damping that was simulated on every wall")
    figure, axes = plt.subplot_mosaic("A" + "BCD"[: len(walls)], constrained_layout=True,
                                      figsize=(TWO_COLUMNS, 0.36 * TWO_COLUMNS))
    times, *ratios = axes.values()
    for wall, colour, marker in zip(walls, (BLUE, VERMILION), MARKERS):
        curve = table.where("wall_a", wall).where("eta", weakest)
        line = {**marker_style(colour, marker), "linestyle": "-", "linewidth": 0.6}
        times.plot(curve["velocity"], curve[DISSIPATION], label=f"$a = {wall:g}/R$", **line)
    times.set_yscale("log")
    ticks(times.yaxis, [0.2, 0.5, 1, 2, 5])
    times.set_ylabel(r"$\tau_0 k_a/\eta$ at $\eta^* = " + f"{weakest:g}$")
    times.legend(loc="lower right")
    for ax, wall in zip(ratios, walls):
        on_wall = table.where("wall_a", wall)
        first = on_wall.where("eta", weakest)[DISSIPATION]
        for eta, style in styles.items():
            curve = on_wall.where("eta", eta)
            if eta in (0, weakest) or len(curve["eta"]) == 0:
                continue
            line = {**marker_style(*style), "linestyle": "-", "linewidth": 0.6}
            ax.plot(curve["velocity"], curve[DISSIPATION] / first, **line)
        ax.axhline(1, color=GREY, linewidth=0.6)
        ax.set_ylim(0.6, 1.06)
        label_panel(ax, f"$a = {wall:g}/R$", 0.06, 0.08)
    ratios[0].set_ylabel(rf"$\tau_0/\eta$ over that at $\eta^* = {weakest:g}$")
    for ax in ratios[1:]:
        ax.set_yticklabels([])
    for ax in axes.values():
        speed_axis(ax, [0.003, 0.01, 0.05])
        ax.set_xlabel("$v/c$")
    letter(axes.values())
    shown = {eta: style for eta, style in styles.items() if eta not in (0, weakest)}
    legend_beside(ratios[-1], damping_handles(shown))
    save_both(figure, folder, "figure3_dissipation")


def figure3_duration(folder, table):
    """Contact duration against speed without damping."""
    figure, ((ax,),) = panels(ONE_COLUMN, 0.8 * ONE_COLUMN)
    undamped = table.where("eta", 0)
    for wall, colour, marker in zip(np.unique(table["wall_a"]), (BLUE, VERMILION), MARKERS):
        curve = undamped.where("wall_a", wall)
        ax.plot(
            curve["velocity"],
            curve["contact_duration"],
            label=f"$a = {wall:g}/R$",
            **marker_style(colour, marker),
        )
    theory = r"$\pi (R/c_s) \sqrt{\ln(4c_s/v)}$"
    ax.plot(curve["velocity"], curve["contact_duration_theory"], color=BLACK, label=theory)
    speed_axis(ax)
    ax.set_xlabel("$v/c$")
    sound_speed_axis(ax, table)
    ax.set_ylabel("contact duration $(R/c)$")
    ax.yaxis.set_major_locator(MultipleLocator(5))
    ax.set_ylim(0, None)
    ax.legend()
    save_both(figure, folder, "figure3_duration")


PARTS = {"spin": SKY, "vibration": ORANGE, "damping": GREY}


def draw_losses(table):
    """Where the loss 1 − e² goes, in shares, against speed on the softer wall: figure and panels."""
    on_wall = table.where("wall_a", min(table["wall_a"]))
    etas = [eta for eta in (0, 1, 10) if eta in on_wall["eta"]]
    figure, (axes,) = panels(TWO_COLUMNS, 0.34 * TWO_COLUMNS, columns=len(etas), sharey=True)
    for ax, eta in zip(axes, etas):
        curve = on_wall.where("eta", eta)
        shares = [curve[part] / curve["loss"] for part in PARTS]
        ax.stackplot(curve["velocity"], shares, colors=PARTS.values(), linewidth=0)
        for boundary in np.cumsum(shares, axis=0)[:-1]:
            ax.plot(curve["velocity"], boundary, color="white", linewidth=0.6)
        speed_axis(ax, [0.003, 0.01, 0.05])
        ax.set_xlim(min(curve["velocity"]), max(curve["velocity"]))
        ax.set_ylim(0, 1)
        ax.set_xlabel("$v/c$")
        ax.set_title(rf"$\eta^* = {eta:g}$", fontsize=8)
    axes[0].set_ylabel("share of $1 - e^2$")
    letter(axes)
    legend_beside(axes[-1], [Patch(color=colour, label=part) for part, colour in PARTS.items()])
    return figure, axes


def figure3_losses(folder):
    """The figure of draw_losses()."""
    figure, _ = draw_losses(read_table(folder / "figure3_losses.csv"))
    save_both(figure, folder, "figure3_losses")
