"""A run as it was recorded: in the folder of `impact --output`, or in a bag."""

from pathlib import Path

import numpy as np

from .program import InputError

OTHERS = ("wall", "wall2", "wall3")  # names of what the disk meets


class Recording:
    """One run. `scene`: as used, nested by key; `bodies`: the disk and, as far as that is made of
    points, what it meets."""

    def __init__(self, path, scene, bodies):
        self.path = path
        self.scene = scene
        self.bodies = bodies
        self.disk = bodies[0]

    def check_states(self):
        """@throw InputError when no states were recorded."""

    def states(self):
        """Every recorded state, in the order of time."""
        raise NotImplementedError

    def times(self):
        """Of all states."""
        raise NotImplementedError

    def history(self):
        """The course of the run, see history.History."""
        raise NotImplementedError

    @property
    def hits_disk(self):
        """Whether the other bodies are disks."""
        return (self.scene.get("wall") or {}).get("type") == "disk"

    @property
    def has_elastic_wall(self):
        """Whether the other body is a wall."""
        return len(self.bodies) > 1 and not self.hits_disk

    @property
    def disk_rows(self):
        """The number of points of the disk: the first rows of a state's arrays."""
        return len(self.disk.points)

    @property
    def first_rows(self):
        """Of each body in a state's arrays."""
        sizes = [len(body.points) for body in self.bodies]
        return np.cumsum([0, *sizes[:-1]])

    def bonds(self):
        """Of all bodies, by the rows of a state's arrays."""
        return np.concatenate([body.bonds + first for body, first
                               in zip(self.bodies, self.first_rows)])

    def parts(self, rows):
        """An array of all points, body by body."""
        return np.split(rows, self.first_rows[1:])

    def strains(self, state):
        """Of the bonds of all bodies."""
        parts = zip(self.bodies, self.parts(state.position))
        return np.concatenate([body.strains(position) for body, position in parts])

    def number(self, part, key, otherwise=None):
        """A number of the scene."""
        value = (self.scene.get(part) or {}).get(key, otherwise)
        try:
            return float(value)
        except (TypeError, ValueError):
            raise InputError(f"{self.path}: its scene has no number {part}.{key}") from None


def open_recording(path, run=None):
    """@param run: of a series in a bag, from 0; None: the last one.
    @throw InputError when there is no such run."""
    path = Path(path)
    if path.is_dir():
        from .folder import FolderRecording  # pylint: disable=import-outside-toplevel

        if run not in (None, 0):
            raise InputError(f"{path}: a folder holds one run, --run 0")
        return FolderRecording(path)
    if not path.exists():
        raise InputError(f"{path}: there is no such folder or bag")
    from .bag import BagRecording  # pylint: disable=import-outside-toplevel

    return BagRecording(path, run)
