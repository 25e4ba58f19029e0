"""Tables of numbers and texts from CSV files."""

import csv

import numpy as np

from .program import InputError


class Table(dict):
    """The columns of a CSV file by name: arrays of numbers, or of texts where there are any."""

    def __init__(self, path, columns):
        super().__init__(columns)
        self.path = path

    def __missing__(self, column):
        raise InputError(f"{self.path}: has no {column}")

    def where(self, column, value):
        """The rows with this value."""
        return self.rows(self[column] == value)

    def rows(self, chosen):
        """These rows, given by an array of bool."""
        return Table(self.path, {name: cells[chosen] for name, cells in self.items()})

    def first_row(self):
        """The cells of the first row by column."""
        return Table(self.path, {name: cells[0] for name, cells in self.items() if len(cells)})


def read_table(path):
    """A table from a CSV file; a text in it may be quoted, with backslashes as in C."""
    try:
        with open(path, newline="", encoding="utf-8") as file:
            names, *rows = csv.reader(file, escapechar="\\")
    except OSError as error:
        raise InputError(f"{path}: {error.strerror}") from None
    except (ValueError, csv.Error) as error:
        raise InputError(f"{path}: is no CSV file with a header ({error})") from None
    uneven = [number for number, row in enumerate(rows, 2) if len(row) != len(names)]
    if uneven:
        raise InputError(f"{path}:{uneven[0]}: has not the {len(names)} cells of the header")
    columns = zip(*rows) if rows else [()] * len(names)
    return Table(path, {name: array(cells) for name, cells in zip(names, columns)})


def array(cells):
    """An array of numbers if all cells are, empty ones but not all of them as NaN, else of texts."""
    if not any(cells):
        return np.array(cells)
    try:
        return np.array([float(cell or "nan") for cell in cells])
    except ValueError:
        return np.array(cells)
