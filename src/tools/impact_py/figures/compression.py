"""Figure 2: compression against load; pressure under the contact."""

import numpy as np
from matplotlib.ticker import MultipleLocator

from ..style import (BLACK, BLUE, GREEN, ORANGE, PURPLE, SKY, TWO_COLUMNS, letter, marker_style,
                     panels, save_both)
from ..tables import read_table


def draw_compression(ax, folder):
    """Compression against load, and the laws."""
    table = read_table(folder / "figure2.csv")
    fits = read_table(folder / "figure2_fits.csv")
    fit = fits.where("case", "default").first_row()
    x = 1e3 * table["P_by_pi_E_R"]
    ax.errorbar(
        x,
        1e2 * table["strain"],
        1e2 * table["strain_error"],
        label="lattices",
        elinewidth=0.7,
        capsize=1.5,
        zorder=3,
        **marker_style(BLACK, "o"),
    )
    b = f"{fit['b']:.3f} \\pm {fit['b_sampling_error']:.3f}"
    laws = (
        ("fit", f"fit of eq. (2), $b = {b}$", BLUE, "-"),
        ("hertz", rf"eq. (2), $b = 1 - \nu^2 = {fit['theory']:.3f}$", ORANGE, "--"),
        ("inertial_load", "uniform body force", GREEN, "-."),
        ("paper_fit", f"eq. (2), $b = {fit['paper']:.2f}$ (paper)", PURPLE, ":"),
    )
    for column, label, colour, style in laws:
        ax.plot(x, 1e2 * table[column], style, color=colour, label=label)
    ax.set_xlabel(r"$P/(\pi E R)$ $(10^{-3})$")
    ax.set_ylabel(r"$\xi/R$ $(10^{-2})$")
    ax.set_xlim(1, 3.1)
    ax.xaxis.set_major_locator(MultipleLocator(0.5))
    ax.set_ylim(0, 3.2)
    ax.legend(loc="upper left")


def draw_pressure(ax, folder):
    """Pressure under the contact, mean of both of its halves, and Hertz's half-ellipse."""
    table = read_table(folder / "figure2_pressure.csv")
    angle = np.linspace(0, np.pi / 2, 200)
    ax.plot(np.cos(angle), 2 / np.pi * np.sin(angle), color=BLACK, label="Hertz")
    x = table["x_by_half_width"]
    cases = (
        ("N_1099", "$N = 1099$, $a = 300/R$", SKY, "o"),
        ("N_16000", "$N = 16000$, $a = 300/R$", ORANGE, "s"),
        ("N_16000_a_3000", "$N = 16000$, $a = 3000/R$", BLUE, "D"),
    )
    for column, label, colour, marker in cases:
        pressure = 0.5 * (table[column] + table[column][::-1])
        line = {**marker_style(colour, marker), "linestyle": "-", "linewidth": 0.5}
        ax.plot(x[x > 0], pressure[x > 0], label=label, **line)
    ax.set_xlabel("$|x|/a_c$")
    ax.set_ylabel("$p\\,a_c/P$")
    ax.set_xlim(0, 2)
    ax.set_ylim(0, None)
    ax.legend(loc="upper right")


def figure2(folder):
    """Compression against load; pressure under the contact."""
    figure, ((compression, pressure),) = panels(TWO_COLUMNS, 0.4 * TWO_COLUMNS, columns=2)
    draw_compression(compression, folder)
    draw_pressure(pressure, folder)
    letter((compression, pressure))
    save_both(figure, folder, "figure2")
