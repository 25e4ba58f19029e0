"""Figures 1 and 4: a lattice on its wall, bonds coloured by strain, and the contact forces."""

import numpy as np
from matplotlib.ticker import MultipleLocator
from PIL import Image

from ..lattice_drawing import LatticeDrawing, strain_bar, strain_limit
from ..program import unfinished
from ..style import BLACK, TWO_COLUMNS, letter, panels, plt, save_both
from ..tables import read_table


def draw_contact(folder, name, height, window):
    """The whole lattice, and its contact: x and y within `window`."""
    points = read_table(folder / f"{name}_points.csv")
    bonds = read_table(folder / f"{name}_bonds.csv")
    position = np.column_stack((points["x"], points["y"]))
    force = np.column_stack((points["fx"], points["fy"]))
    ends = np.column_stack((bonds["first"], bonds["second"])).astype(int)
    limit = strain_limit(bonds["strain"])
    peak = np.max(np.hypot(*force.T))
    figure, (axes,) = panels(TWO_COLUMNS, height, columns=2)
    for ax, linewidth, step in zip(axes, (0.5, 1.0), (0.5, 0.1)):
        drawing = LatticeDrawing(ax, ends, limit, peak, linewidth, longest_arrow=0.22)
        drawing.show(position, bonds["strain"], force)
        ax.xaxis.set_major_locator(MultipleLocator(step))
        ax.yaxis.set_major_locator(MultipleLocator(step))
        ax.set_xlabel("$x/R$")
        ax.set_ylabel("$y/R$")
    (left, right), (low, high) = window
    axes[0].set_xlim(position[:, 0].min() - 0.1, position[:, 0].max() + 0.1)
    axes[0].set_ylim(position[:, 1].min() - 0.1, position[:, 1].max() + 0.1)
    axes[0].add_patch(
        plt.Rectangle((left, low), right - left, high - low, fill=False, linewidth=0.8, zorder=5)
    )
    axes[1].plot(points["x"], points["y"], ".", color=BLACK, markersize=3.5, markeredgewidth=0)
    axes[1].set_xlim(left, right)
    axes[1].set_ylim(low, high)
    strain_bar(figure, drawing, axes)
    letter(axes)
    return figure, axes


def save_small(figure, folder, name):
    """Many thin lines compress badly with all their shades, so the PNG has few colours."""
    save_both(figure, folder, name)
    path = folder / f"{name}.png"
    with unfinished(path) as beside:
        few = Image.open(path).convert("RGB").quantize(192, dither=Image.Dither.NONE)
        few.save(beside, format="png", optimize=True)


def figure1(folder):
    """The disk pressed on the potential wall."""
    window = (-0.35, 0.35), (-0.12, 0.58)
    figure, axes = draw_contact(folder, "figure1", 0.42 * TWO_COLUMNS, window)
    axes[0].set_ylim(-0.2, 2.1)
    for ax in axes:
        ax.axhspan(-1, 0, facecolor="0.85", edgecolor=BLACK, linewidth=0.8, zorder=0)
    save_small(figure, folder, "figure1")


def figure4(folder):
    """The disk at its deepest in the elastic wall."""
    window = (-0.35, 0.35), (-0.42, 0.28)
    figure, _ = draw_contact(folder, "figure4", 0.46 * TWO_COLUMNS, window)
    save_small(figure, folder, "figure4")
