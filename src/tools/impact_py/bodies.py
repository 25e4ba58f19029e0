"""Lattices, and what a state of them holds."""

from dataclasses import dataclass

import numpy as np

from .program import InputError


@dataclass
class Body:
    """A lattice in its stress-free reference configuration; lengths in R, the mass in M."""

    points: np.ndarray  # one row a point: x, y
    bonds: np.ndarray  # one row a bond: two indices
    natural_lengths: np.ndarray
    point_mass: float

    def lengths(self, position):
        """Of all bonds."""
        ends = position[self.bonds]
        return np.hypot(*(ends[:, 1] - ends[:, 0]).T)

    def strains(self, position):
        """Of all bonds: elongation over natural length."""
        return self.lengths(position) / self.natural_lengths - 1.0

    def bond_energy(self, position, k_a, k_b):
        """Σ k_a x²/2 + k_b x⁴/4 over the bonds' elongations x, in M c²."""
        square = (self.lengths(position) - self.natural_lengths) ** 2
        return float(np.sum(square * (0.5 * k_a + 0.25 * k_b * square)))


@dataclass
class State:
    """All points at one time: those of the disk and, after them, those of what it meets."""

    step: int
    time: float  # R/c
    position: np.ndarray  # R
    velocity: np.ndarray  # c
    force: np.ndarray  # M c²/R, of the contact


def compression(reference, position):
    """ξ = R′₀ − R′: by how much the centre of mass has come nearer to the lowest point than in the
    unloaded lattice, equally turned."""
    arms = reference - reference.mean(axis=0)
    cross = np.sum(arms[:, 0] * position[:, 1] - arms[:, 1] * position[:, 0])
    turn = np.arctan2(cross, np.sum(arms * position))
    lowest = np.min(np.sin(turn) * arms[:, 0] + np.cos(turn) * arms[:, 1])
    height = position[:, 1].mean() - position[:, 1].min()
    return -lowest - height


def kinetic_energies(position, velocity, mass):
    """Translation, rotation and vibration of a body of equal points, in M c²."""
    arms = position - position.mean(axis=0)
    mean = velocity.mean(axis=0)
    inertia = mass * np.sum(arms**2)
    momentum = mass * np.sum(arms[:, 0] * velocity[:, 1] - arms[:, 1] * velocity[:, 0])
    translation = 0.5 * mass * len(position) * np.sum(mean**2)
    rotation = 0.5 * momentum**2 / inertia
    return translation, rotation, 0.5 * mass * np.sum(velocity**2) - translation - rotation


def read_lammps_data(path):
    """A body from a lattice.data, wall.data, … that `impact` wrote."""
    sections = {}
    rows = None
    with open(path, encoding="utf-8") as file:
        for line in file:
            words = line.split("#")[0].split()
            if words and words[0] in ("Masses", "Atoms", "Bonds"):
                rows = sections[words[0]] = []
            elif words and rows is not None:
                rows.append(words)
    try:
        points = np.array([row[3:5] for row in sections["Atoms"]], dtype=float)
        bonds = np.array([row[2:4] for row in sections["Bonds"]], dtype=int).reshape(-1, 2) - 1
        mass = float(sections["Masses"][0][1])
        body = Body(points, bonds, np.ones(len(bonds)), mass)
        body.natural_lengths = body.lengths(points)
    except (KeyError, IndexError, ValueError):
        raise InputError(f"{path}: is no lattice that impact wrote") from None
    return body
