"""A run as it was recorded: in the folder of `impact --output`, or in a bag."""

from pathlib import Path

import numpy as np

from .program import InputError


class Recording:
    """One run. `scene`: as used, nested by key; `disk`, `wall`: bodies, the second an elastic wall
    or another disk, or None."""

    def __init__(self, path, scene, disk, wall):
        self.path = path
        self.scene = scene
        self.disk = disk
        self.wall = wall

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
    def bodies(self):
        """The disk and, if there is one, the second body."""
        return [self.disk] if self.wall is None else [self.disk, self.wall]

    @property
    def hits_disk(self):
        """Whether the second body is another disk."""
        return (self.scene.get("wall") or {}).get("type") == "disk"

    @property
    def disk_rows(self):
        """The number of points of the disk: the first rows of a state's arrays."""
        return len(self.disk.points)

    def bonds(self):
        """Of all bodies, by the rows of a state's arrays."""
        shifted = [self.disk.bonds]
        if self.wall is not None:
            shifted.append(self.wall.bonds + self.disk_rows)
        return np.concatenate(shifted)

    def parts(self, rows):
        """An array of all points, body by body."""
        return np.split(rows, [self.disk_rows])[: len(self.bodies)]

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
