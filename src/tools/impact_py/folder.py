"""The folder of `impact --output`."""

import itertools

import numpy as np
import yaml

from .bodies import State, read_lammps_data
from .history import read_history
from .program import InputError
from .recording import OTHERS, Recording

STATES = "states.lammpstrj"
COLUMNS = "id type x y z vx vy vz fx fy fz".split()


class FolderRecording(Recording):
    """Its states are there if `impact` was told --states."""

    def __init__(self, path):
        try:
            scene = yaml.safe_load((path / "scene.yaml").read_text(encoding="utf-8"))
            disk = read_lammps_data(path / "lattice.data")
        except OSError as error:
            raise InputError(f"{error.filename}: {error.strerror}; is {path} a folder of "
                             "impact --output?") from None
        others = [path / f"{name}.data" for name in OTHERS]
        bodies = [disk, *(read_lammps_data(file) for file in others if file.exists())]
        super().__init__(path, scene, bodies)

    def history(self):
        return read_history(self.path / "history.csv")

    def times(self):
        return self.history().time

    def check_states(self):
        path = self.path / STATES
        if not path.exists():
            raise InputError(f"{path}: there are no states; impact … --output {self.path} --states "
                             "keeps them")

    def states(self):
        self.check_states()
        points = sum(len(body.points) for body in self.bodies)
        with open(self.path / STATES, encoding="utf-8") as file:
            yield from read_dump(file, points)


def read_dump(file, points):
    """The states of a LAMMPS dump with the columns that `impact` writes, points by their ids."""
    for line in file:
        try:
            time = float(_after(line, "TIME", file))
            step = int(_after(next(file), "TIMESTEP", file))
            count = int(_after(next(file), "NUMBER OF ATOMS", file))
            box = [next(file) for _ in range(4)]
            columns = next(file).split()[2:]
            lines = "".join(itertools.islice(file, count))
            rows = np.fromstring(lines, sep=" ").reshape(count, -1)
            if columns != COLUMNS or rows.shape != (points, len(COLUMNS)) or "BOX" not in box[0]:
                raise ValueError
        except (ValueError, StopIteration):
            raise InputError(f"{file.name}: is no dump of this run by impact") from None
        rows = rows[np.argsort(rows[:, 0])]
        yield State(step, time, rows[:, 2:4], rows[:, 5:7], rows[:, 8:10])


def _after(header, item, file):
    if header.strip() != f"ITEM: {item}":
        raise ValueError
    return next(file)
