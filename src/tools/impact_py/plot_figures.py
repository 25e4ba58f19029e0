"""Draws the CSV files of `reproduce`, `work_precision` and `accuracy_check`, as SVG and PNG."""

from pathlib import Path

from .program import Parser, run

NAMES = ("accuracy", "figure1", "figure2", "figure3", "figure4", "figure6", "oblique", "work_precision",
         "all")


def main():
    """The program plot_figures."""
    parser = Parser("plot_figures", description=__doc__)
    parser.add_argument("figure", choices=NAMES, help="all: those of reproduce all")
    parser.add_argument("folder", type=Path, help="where the CSV files are")
    run(parser, perform)


def perform(arguments):
    """Draws what the command line names."""
    # pylint: disable=import-outside-toplevel
    from . import style
    from .figures import (accuracy, compression, elastic_wall, lattices, oblique, precision,
                          restitution)

    style.choose_window(False)
    figures = {
        "figure1": lattices.figure1,
        "figure2": compression.figure2,
        "figure3": restitution.figure3,
        "figure4": lattices.figure4,
        "figure6": elastic_wall.figure6,
        "accuracy": accuracy.figure_accuracy,
        "oblique": oblique.figure_oblique,
        "work_precision": precision.figures_of_precision,
    }
    names = [arguments.figure]
    if arguments.figure == "all":
        names = [name for name in figures if name.startswith("figure")]
    for name in names:
        figures[name](arguments.folder)
