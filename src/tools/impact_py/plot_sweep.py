"""Draws columns of a CSV file of `sweep` against another: means over the seeds with their standard
errors, one curve for each column and each combination of the other keys that were swept."""

import itertools
import math
import sys
from pathlib import Path

from .program import InputError, PICTURES, Parser, check_picture, run

NOT_SWEPT = "seed"
# What answers each kind of scene, against what.
ANSWERS = (("impact.velocity", "restitution"), ("load.P", "strain"),
           ("stretch.strain", "young_modulus"))
LABELS = {"impact.velocity": "$v/c$", "material.eta": r"$\eta^*$", "restitution": "$e$",
          "load.P": "$P$ $(M c^2/R)$", "strain": r"$\xi$ $(R)$", "disk.points": "$N$",
          "contact_duration": "contact duration $(R/c)$", "peak_force": "peak force $(M c^2/R)$",
          "spin_after": "spin after $(c/R)$", "young_modulus": "$E$ $(M c^2/R^2)$",
          "impact.angle": "angle (degrees)", "impact.spin": r"$\omega$ $(c/R)$",
          "tangential_restitution": r"$\beta$", "normal_energy": "normal energy after",
          "tangential_energy": "tangential energy after", "rotation_energy": "rotation energy after",
          "surface_slope": "slope of the surface", "impulse_ratio": "ratio of impulses", "wall.a": "$a$ $(1/R)$",
          "wall.k_a": "wall's $k_a$ $(M c^2/R^2)$", "wall.disks": "disks in the row",
          "momentum_passed_on": "momentum passed on", "restitution_of_ends": "$e$ of the ends"}


def main():
    """The program plot_sweep."""
    parser = Parser("plot_sweep", description=__doc__)
    parser.add_argument("file", type=Path, metavar="FILE.csv")
    parser.add_argument("x", nargs="?", help="column; without it the velocity or the load of an "
                        "answer, else the first key that was swept")
    parser.add_argument("y", nargs="*", help="columns; without them what the scene answers: "
                        "restitution, strain or young_modulus")
    parser.add_argument("--output", type=Path, metavar="FILE",
                        help=f"picture, {', '.join(PICTURES)}; without it and without a display: "
                        "a .png beside the input")
    run(parser, perform)


def perform(arguments):
    """Draws what the command line asks for."""
    check_picture(arguments.output)
    # pylint: disable=import-outside-toplevel
    from .tables import read_table

    table = read_table(arguments.file)
    x, columns = chosen_columns(table, arguments.x, arguments.y)
    from . import style

    shown = style.choose_window(arguments.output is None)
    figure = draw_sweep(table, x, columns)
    if shown:
        style.plt.show()
        return
    path = arguments.output or arguments.file.with_suffix(".png")
    style.save(figure, path)
    print(path)


def keys_of(table):
    """The columns of the scene: up to the last with a dot, since results have none."""
    names = list(table)
    last = max((i for i, name in enumerate(names) if "." in name), default=-1)
    return names[: last + 1]


def swept_keys(table):
    """The keys of the scene with several values, without the seed."""
    return [key for key in keys_of(table) if key != NOT_SWEPT and len(set(table[key])) > 1]


def column_named(table, name):
    """A column by its name, or by the last part of it where that is unambiguous."""
    if name in table:
        return name
    ends = [column for column in table if column.rpartition(".")[2] == name]
    if len(ends) == 1:
        return ends[0]
    numbers = [column for column, cells in table.items() if cells.dtype.kind == "f"]
    raise InputError(f"{table.path}: has no {name}, only {', '.join(numbers)}")


def chosen_columns(table, x, columns):
    """What to draw against what: x and a list."""
    if not table or len(next(iter(table.values()))) == 0:
        raise InputError(f"{table.path}: has no rows")
    swept = swept_keys(table)
    answered = [(key, answer) for key, answer in ANSWERS if answer in table]
    if x is None:
        x = next((key for key, _ in answered if key in swept), swept[0] if swept else None)
        if x is None:
            raise InputError(f"{table.path}: no key was swept but the seed; say which x")
    if not columns:
        if not answered:
            raise InputError(f"{table.path}: has no {' or '.join(dict(ANSWERS).values())}; say "
                             "which y")
        columns = [answered[0][1]]
    x, *columns = [column_named(table, name) for name in (x, *columns)]
    for name in (x, *columns):
        if table[name].dtype.kind != "f":
            raise InputError(f"{table.path}: {name} is no column of numbers")
    return x, columns


def curves(table, x, y):
    """[(values of the other swept keys, x, mean of y, its standard error, seeds)]. Rows without a
    number are left out. The error of one seed alone is the one that the row states, if any."""
    # pylint: disable=import-outside-toplevel
    import numpy as np

    known = table.rows(np.isfinite(table[x]) & np.isfinite(table[y]))
    others = [key for key in swept_keys(table) if key != x]
    found = []
    for values in itertools.product(*(np.unique(known[key]) for key in others)):
        part = known
        for key, value in zip(others, values):
            part = part.where(key, value)
        places = np.unique(part[x])
        groups = [part.where(x, place) for place in places]
        if not groups:
            continue
        counts = np.array([len(group[y]) for group in groups])
        means = np.array([group[y].mean() for group in groups])
        errors = np.array([standard_error(group, y) for group in groups])
        found.append((dict(zip(others, values)), places, means, errors, counts))
    return found


def standard_error(group, y):
    """Of the mean of y over the rows of a group."""
    count = len(group[y])
    if count > 1:
        return group[y].std(ddof=1) / count**0.5
    stated = group.get(f"{y}_error", "none")[0]
    return stated if isinstance(stated, float) and math.isfinite(stated) else 0.0


def curves_of_all(table, x, columns):
    """[(what to call it, as curves() without the values)] of several columns."""
    found = []
    for y in columns:
        counted = 0
        for values, *curve in curves(table, x, y):
            names = [LABELS.get(y, y)] if len(columns) > 1 else []
            names += [f"{LABELS.get(key, key)} = {plain(value)}" for key, value in values.items()]
            found.append((", ".join(names), *curve))
            counted += curve[-1].sum()
        if not counted:
            raise InputError(f"{table.path}: no row has a number for {x} and {y}")
        left_out = len(table[y]) - counted
        if left_out:
            print(f"{table.path}: left out without a number: {left_out} of {len(table[y])} rows",
                  file=sys.stderr)
    return found


def draw_sweep(table, x, columns):
    """The figure."""
    # pylint: disable=import-outside-toplevel
    import numpy as np

    from . import style

    found = curves_of_all(table, x, columns)
    figure, ((ax,),) = style.panels(1.5 * style.ONE_COLUMN, 0.9 * style.ONE_COLUMN)
    colours = style.plt.cm.viridis(np.linspace(0, 0.87, len(found)))
    for (label, places, means, errors, _), colour, marker in zip(
            found, colours, itertools.cycle(style.MARKERS)):
        line = {**style.marker_style(colour, marker), "linestyle": "-", "linewidth": 0.6}
        ax.errorbar(places, means, errors, elinewidth=0.7, capsize=1.5, label=label, **line)
    places = np.unique(table[x])
    if places[0] > 0 and places[-1] > 8 * places[0]:
        ax.set_xscale("log")
        style.plain_log_axis(ax.xaxis, places[0], places[-1])
    ax.set_xlabel(LABELS.get(x, x))
    if len(columns) == 1:
        ax.set_ylabel(LABELS.get(columns[0], columns[0]))
    seeds = max(counts.max() for *_, counts in found)
    if len(found) > 1 or seeds > 1:
        title = f"mean of {seeds} seeds" if seeds > 1 else None
        handles, labels = ax.get_legend_handles_labels()
        shown = [(handle, label) for handle, label in zip(handles, labels) if label]
        ax.legend(*(zip(*shown) if shown else ((), ())), loc="upper left",
                  bbox_to_anchor=(1.02, 1.0), title=title, alignment="left")
    return figure


def plain(value):
    """A number without needless digits, or a text."""
    return f"{value:.4g}" if isinstance(value, float) else str(value)
