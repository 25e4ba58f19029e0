"""Error against run time, of each integrator and of the number of points."""

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.patheffects import withStroke
from matplotlib.ticker import FixedFormatter, FixedLocator, NullLocator

from ..style import (BLACK, BLUE, GREEN, GREY, ORANGE, PURPLE, SKY, TWO_COLUMNS, VERMILION,
                     label_panel, legend_beside, letter, log_axes, marker_style, panels, save_both)
from ..tables import read_table

# Integrator, colour, marker, filled.
INTEGRATORS = (
    ("verlet", BLUE, "o", True),
    ("takahashi_imada", BLACK, "p", True),
    ("blanes_moan", VERMILION, "s", True),
    ("implicit_damping", SKY, "^", True),
    ("extrapolated_damping", ORANGE, "D", True),
    ("imex", BLACK, "*", True),
    ("bdf", GREEN, "v", True),
    ("rk8pd", PURPLE, "P", True),
    ("newton", GREY, "X", True),
)
PRECISION_SCENES = (
    ("contact", r"$\xi$"),
    ("collision_eta0", "$e$"),
    ("collision_eta1", "$e$"),
    ("collision_eta100", "$e$"),
    ("absorbing_wall", "$e$"),
)


def shade_unknown(ax, uncertainty):
    """Shades the errors that the reference cannot show."""
    low, high = ax.get_ylim()
    ax.axhspan(0.01 * uncertainty, uncertainty, facecolor="0.9", linewidth=0, zorder=0)
    ax.set_ylim(max(low, 0.1 * uncertainty), high)


def shown(errors, uncertainty):
    """The errors, those that the reference cannot show at one place below its uncertainty."""
    return np.where(errors < uncertainty, 0.3 * uncertainty, errors)


def draw_curves(ax, curves, x, y, uncertainty):
    """The errors `y` against the work `x` for each integrator."""
    for name, *style in INTEGRATORS:
        curve = curves.where("integrator", name)
        line = {**marker_style(*style), "linestyle": "-", "linewidth": 0.7}
        ax.plot(curve[x], shown(curve[y], uncertainty), **line)


def draw_front(ax, table, uncertainty):
    """The Pareto front, behind the curves and to the edges of the panel."""
    front = table.where("on_front", 1)
    order = np.argsort(front["time"])
    (left, right), (low, high) = ax.get_xlim(), ax.get_ylim()
    x = [front["time"][order[0]], *front["time"][order], right]
    errors = shown(front["error"][order], uncertainty)
    y = [high, *errors, errors[-1]]
    ax.step(x, y, where="post", color=BLACK, linewidth=0.6, zorder=1)
    ax.set_xlim(left, right)
    ax.set_ylim(low, high)


def precision_handles(curves):
    """The legend's entries of the integrators that there are, the front and auto."""
    handles = [
        Line2D([], [], label=name, linewidth=0.7, **marker_style(*style))
        for name, *style in INTEGRATORS
        if len(curves.where("integrator", name)["error"])
    ]
    handles.append(Line2D([], [], color=BLACK, linewidth=0.6, label="Pareto front"))
    style = marker_style(BLACK, "*", False)
    label = "auto, verified, with\nthe wanted error"
    handles.append(Line2D([], [], label=label, markersize=7, **style))
    return handles


NEAR = 2  # answers whose times and errors differ by less than this factor are one in the figure


def groups_of_answers(times, errors):
    """Lists of indices of the answers that lie near the first of each list."""
    groups = []
    for index in range(len(times)):
        for group in groups:
            ratios = times[index] / times[group[0]], errors[index] / errors[group[0]]
            if all(1 / NEAR < ratio < NEAR for ratio in ratios):
                group.append(index)
                break
        else:
            groups.append([index])
    return groups


def power_of_ten(value):
    """As a text."""
    return f"10^{{{round(np.log10(value))}}}"


# Where a label may stand beside its mark: shift in points, and what of it is there.
PLACES = [(dict(xytext=(5 * right, 3 * up)),
           dict(ha="left" if right > 0 else "right", va="bottom" if up > 0 else "top"))
          for right in (1, -1) for up in (1, -1)]
PLACES += [(dict(xytext=(0, 6 * up)), dict(ha="center", va="bottom" if up > 0 else "top"))
           for up in (1, -1)]


def pixels_along(line, transform):
    """Places on a curve, ten from one of its points to the next."""
    corners = transform.transform(line.get_xydata())
    steps = np.linspace(0, len(corners) - 1, 10 * len(corners))
    return np.column_stack([np.interp(steps, range(len(corners)), axis) for axis in corners.T])


def covered(ax, label, others):
    """How much of the curves lies under the label; labels, and what lies beyond the panel, count
    more."""
    box = label.get_window_extent()
    places = np.concatenate([pixels_along(line, ax.transData) for line in ax.lines
                             if len(line.get_xydata())])
    hidden = np.all((box.min < places) & (places < box.max), axis=1)
    panel = ax.get_window_extent()
    leaves = np.any(box.min < panel.min) or np.any(panel.max < box.max)
    overlaps = sum(box.overlaps(other.get_window_extent()) for other in others)
    return np.count_nonzero(hidden) + 1000 * overlaps + 10000 * leaves


def label_marks(ax, labels):
    """Writes each text beside its place, where it covers least."""
    ax.figure.draw_without_rendering()
    written = []
    for text, place in labels:
        tries = []
        for shift, side in PLACES:
            label = ax.annotate(text, place, textcoords="offset points", fontsize=6, zorder=5,
                                **shift, **side)
            label.set_path_effects([withStroke(linewidth=1.5, foreground="white")])
            tries.append(label)
        best = min(tries, key=lambda label: covered(ax, label, written))
        written.append(best)
        for label in tries:
            if label is not best:
                label.remove()


def draw_automatic(ax, automatic, uncertainty):
    """The verified answers of `auto`, one star for equal ones. Returns the wanted errors as texts,
    with their places."""
    labels = []
    wanted, times = automatic["wanted_error"], automatic["time"]
    errors = shown(automatic["error"], uncertainty)
    style = {**marker_style(BLACK, "*", False), "markersize": 7, "zorder": 4}
    for group in groups_of_answers(times, errors):
        middle = [np.exp(np.mean(np.log(values[group]))) for values in (times, errors)]
        ax.plot(*middle, **style)
        most, least = max(wanted[group]), min(wanted[group])
        text = power_of_ten(most)
        if least < most:
            text += r"\,\ldots\," + power_of_ten(least)
        labels.append((f"${text}$", middle))
    return labels


def work_precision_figure(folder, name, symbol):
    """Error of the answer against run time; error of the positions against force evaluations."""
    table = read_table(folder / f"work_precision_{name}.csv")
    reference = read_table(folder / "references.csv").where("scene", name).first_row()
    automatic = table.where("integrator", "auto")
    runs = table.where("kind", "run")
    curves = runs if len(runs["kind"]) else table.where("kind", "verified")
    figure, (axes,) = panels(TWO_COLUMNS, 0.42 * TWO_COLUMNS, columns=2)
    uncertainty = reference["uncertainty"]
    draw_curves(axes[0], curves, "time", "error", uncertainty)
    labels = draw_automatic(axes[0], automatic, uncertainty)
    log_axes(axes[0], "time (s)", f"relative error of {symbol}")
    axes[0].margins(x=0.15, y=0.1)
    draw_front(axes[0], table, uncertainty)
    shade_unknown(axes[0], uncertainty)
    uncertainty = reference["position_uncertainty"]
    draw_curves(axes[1], curves, "force_evaluations", "position_error", uncertainty)
    log_axes(axes[1], "force evaluations", "error of the final positions ($R$)")
    shade_unknown(axes[1], uncertainty)
    letter(axes)
    legend_beside(axes[1], precision_handles(curves))
    label_marks(axes[0], labels)
    save_both(figure, folder, f"work_precision_{name}")


def apart(places, values):
    """Labels of the values, but for those that would overlap the one before."""
    labels, last = [], 0.0
    for place, value in zip(places, values):
        near = place < 1.4 * last
        labels.append("" if near else f"{value:g}")
        last = last if near else place
    return labels


def points_axis(ax, curve):
    """The numbers of points above, where the answers of one lattice lie."""
    ax.tick_params(axis="x", which="both", top=False)
    top = ax.secondary_xaxis("top")
    top.xaxis.set_major_locator(FixedLocator(curve["time"]))
    top.xaxis.set_minor_locator(NullLocator())
    top.xaxis.set_major_formatter(FixedFormatter(apart(curve["time"], curve["points"])))
    top.set_xlabel("$N$")


def figure_discretisation(folder):
    """What the number of points leaves open in e, against the run time of one lattice."""
    table = read_table(folder / "discretisation.csv")
    etas = np.unique(table["eta_of_1099_points"])
    figure, (axes,) = panels(TWO_COLUMNS, 0.42 * TWO_COLUMNS, columns=len(etas), sharey=True)
    for ax, eta in zip(axes, etas):
        curve = table.where("eta_of_1099_points", eta)
        line = {**marker_style(BLUE, "o", False), "linestyle": "--", "linewidth": 0.7}
        ax.plot(curve["time"], curve["scatter"], label="one lattice", **line)
        mean = ax.errorbar(
            curve["time"],
            np.abs(curve["difference"]),
            curve["difference_error"],
            label="mean over lattices",
            elinewidth=0.7,
            capsize=1.5,
            **marker_style(VERMILION, "s"),
        )
        log_axes(ax, "time of a verified answer (s)", "")
        points_axis(ax, curve)
        label_panel(ax, rf"$\eta^* = {eta:g}\,N/1099$" if eta else r"$\eta^* = 0$", 0.55, 0.93)
    axes[0].set_ylabel("error of $e$ by discretisation")
    axes[0].set_ylim(bottom=5e-5)
    letter(axes)
    legend_beside(axes[-1], [*axes[-1].lines[:1], mean])
    save_both(figure, folder, "discretisation")


def figures_of_precision(folder):
    """Error against run time, of all scenes and of the number of points."""
    for name, symbol in PRECISION_SCENES:
        work_precision_figure(folder, name, symbol)
    figure_discretisation(folder)
