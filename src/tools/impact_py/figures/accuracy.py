"""How often the true error is how many times the estimated and the wanted one."""

import numpy as np

from ..style import BLACK, BLUE, GREEN, TWO_COLUMNS, VERMILION, letter, panels, save_both
from ..tables import read_table

KINDS_OF_SCENES = {"potential wall": BLUE, "elastic wall": VERMILION, "contact": GREEN}


def decades(ratios):
    """Decimal logarithms, those beyond the range of the figure at its ends."""
    return np.log10(np.clip(ratios, 1.001e-6, 0.999e6))


def figure_accuracy(folder):
    """How often the true error is how many times the estimated and the wanted one."""
    table = read_table(folder / "accuracy.csv")
    known = np.isin(table["verdict"], ("kept", "broken"))
    of_wanted = np.where(known, table["true_error"] / table["numerics.error"], np.nan)
    columns = (
        (table["true_over_estimated"], "true over estimated error"),
        (of_wanted, "true over wanted error"),
    )
    figure, (axes,) = panels(TWO_COLUMNS, 0.36 * TWO_COLUMNS, columns=2, sharey=True)
    for ax, (ratios, label) in zip(axes, columns):
        chosen = ~np.isnan(ratios)
        ax.hist(
            [decades(ratios[chosen & (table["kind"] == kind)]) for kind in KINDS_OF_SCENES],
            bins=np.linspace(-6, 6, 37),
            stacked=True,
            color=list(KINDS_OF_SCENES.values()),
            label=list(KINDS_OF_SCENES),
        )
        ax.axvline(0, color=BLACK, linewidth=0.6)
        ax.set_xlim(-6, 6)
        ax.set_xlabel(f"$\\log_{{10}}$ of {label}")
    axes[0].axvspan(-2, 2, facecolor="0.92", zorder=0)
    axes[0].set_ylabel("scenes")
    axes[0].legend(loc="upper left")
    letter(axes)
    save_both(figure, folder, "accuracy")
