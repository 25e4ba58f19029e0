"""The look of every figure: sizes, type, colours, axes."""

import os

import matplotlib
import matplotlib.pyplot as plt
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.ticker import FixedLocator, FuncFormatter, NullFormatter, NullLocator

from .program import unfinished

ONE_COLUMN = 89 / 25.4  # inches
TWO_COLUMNS = 180 / 25.4
STYLE = {
    "font.size": 8,
    "axes.labelsize": 8,
    "axes.linewidth": 0.6,
    "xtick.labelsize": 7,
    "ytick.labelsize": 7,
    "xtick.direction": "in",
    "ytick.direction": "in",
    "xtick.top": True,
    "ytick.right": True,
    "legend.fontsize": 7,
    "legend.frameon": False,
    "legend.handlelength": 2.2,
    "lines.linewidth": 1.0,
    "lines.markersize": 3.5,
    "lines.markeredgewidth": 0.7,
    "savefig.dpi": 300,
    "svg.hashsalt": "lattice_impact",
}
MARKERS = "osD^vPX"
# M. Okabe and K. Ito, Color Universal Design (2008).
BLACK, ORANGE, SKY, GREEN, BLUE, VERMILION, PURPLE, GREY = (
    "#000000 #e69f00 #56b4e9 #009e73 #0072b2 #d55e00 #cc79a7 #777777".split()
)
# Compression blue, extension red; told apart by all, and grey, not white, between them.
STRAIN_COLOURS = LinearSegmentedColormap.from_list(
    "strain", ["#053061", "#2166ac", "#67a9cf", "#d4d4d4", "#ef8a62", "#b2182b", "#67001f"]
)


def choose_window(wanted):
    """Uses the style from here on, whatever a matplotlibrc says. Returns whether figures are shown
    in a window: when that is wanted and there are a display and a toolkit."""
    shown = wanted and bool(os.environ.get("DISPLAY")) and matplotlib.get_backend().lower() != "agg"
    backend = matplotlib.get_backend() if shown else "Agg"
    matplotlib.rcdefaults()
    plt.switch_backend(backend)
    plt.rcParams.update(STYLE)
    return shown


def save(figure, path):
    """Writes a figure; the same data make the same bytes."""
    options = {
        ".svg": {"metadata": {"Date": None}},
        ".pdf": {"metadata": {"CreationDate": None}},
        ".png": {"pil_kwargs": {"optimize": True}},
    }[path.suffix]
    with unfinished(path) as beside:
        figure.savefig(beside, format=path.suffix[1:], **options)


KINDS = (".svg", ".png")  # of the figures of the report


def save_both(figure, folder, name):
    """Writes NAME.svg and NAME.png."""
    for kind in KINDS:
        save(figure, folder / (name + kind))
    plt.close(figure)


def panels(width, height, rows=1, columns=1, **options):
    """A figure of panels, and these by row and column; sizes in inches."""
    return plt.subplots(
        rows,
        columns,
        figsize=(width, height),
        constrained_layout=True,
        squeeze=False,
        **options,
    )


def label_panel(ax, text, x, y):
    """Text in a panel; x and y are parts of its width and height."""
    ax.text(x, y, text, transform=ax.transAxes, va="center")


def letter(axes):
    """(a), (b), … above the panels."""
    for name, ax in zip("abcdef", axes):
        place = {"xy": (0, 1), "xycoords": "axes fraction", "textcoords": "offset points"}
        ax.annotate(f"({name})", xytext=(-22, 3), **place)


def legend_beside(ax, handles):
    """A legend right of a panel."""
    ax.legend(handles=handles, loc="upper left", bbox_to_anchor=(1.02, 1.0))


def marker_style(colour, marker, filled=True):
    """Markers without a line."""
    face = colour if filled else "white"
    return {"linestyle": "", "marker": marker, "color": colour, "markerfacecolor": face}


def ticks(axis, values):
    """Exactly these ticks on a logarithmic axis, as plain numbers."""
    axis.set_major_locator(FixedLocator(values))
    axis.set_minor_locator(NullLocator())
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))


def plain_log_axis(axis, low, high):
    """A logarithmic axis with plain numbers: 1, 2 and 5 of each decade if there are few decades."""
    label = FuncFormatter(lambda value, _: f"{value:g}" if f"{value:e}"[0] in "125" else "")
    axis.set_major_formatter(label)
    axis.set_minor_formatter(label if high < 60 * low else NullFormatter())


def log_axes(ax, xlabel, ylabel):
    """Both axes logarithmic, with labels."""
    ax.set_xscale("log")
    ax.set_yscale("log")
    ax.set_xlabel(xlabel)
    ax.set_ylabel(ylabel)
