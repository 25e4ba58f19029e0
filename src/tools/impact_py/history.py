"""The course of a run: compression, wall force, velocity of the centre of mass, energies."""

from dataclasses import dataclass

import numpy as np

from .bodies import compression, kinetic_energies
from .tables import read_table

MOTIONS = ("translation", "rotation", "vibration")
ENERGIES = (*MOTIONS, "bonds", "wall", "wall lattice", "load",
            "dissipated", "absorbed", "hops")


@dataclass
class History:
    """One element a state in each array."""

    time: np.ndarray  # R/c
    strain: np.ndarray  # R, ξ
    force: np.ndarray  # M c²/R, along y
    velocity: np.ndarray  # c, x and y
    energies: dict  # M c², by the names in ENERGIES


def read_history(path):
    """From a history.csv of `impact --output`."""
    table = read_table(path)
    velocity = np.column_stack((table["velocity x [c]"], table["velocity y [c]"]))
    energies = {name: table[f"{name} [M c^2]"] for name in ENERGIES}
    return History(table["time [R/c]"], table["strain [R]"], table["force [M c^2/R]"], velocity,
                   energies)


def measure_history(recording, ledgers):
    """From the states of a recording, except for what is lost: that is what the energy of a state
    misses of the total; `ledgers`, (index of a state, message EnergyLedger)
    in the order of time, tell by which way."""
    rows = [_measures(recording, state) for state in recording.states()]
    columns = {name: np.array([row[name] for row in rows]) for name in rows[0]}
    energies = {name: columns.pop(name) for name in ENERGIES if name in columns}
    lost = ledgers[0][1].total - sum(energies.values())
    known_at = [index for index, _ in ledgers]
    for way in ("dissipated", "hops", "absorbed"):
        course = [getattr(ledger, way) for _, ledger in ledgers]
        energies[way] = np.interp(np.arange(len(lost)), known_at, course)
    if recording.has_elastic_wall:
        energies["absorbed"] = lost - energies["dissipated"] - energies["hops"]
    elif recording.number("material", "eta") > 0.0:
        energies["dissipated"] = lost
    return History(energies=energies, **columns)


def _measures(recording, state):
    disk, *others = recording.parts(state.position)
    disk_velocity, *other_velocities = recording.parts(state.velocity)
    disk_force = state.force[: recording.disk_rows]
    mass = recording.disk.point_mass
    bond_law = _bond_law(recording, "material")
    measures = {
        "time": state.time,
        "strain": compression(recording.disk.points, disk),
        "force": disk_force[:, 1].sum(),
        "velocity": disk_velocity.mean(axis=0),
        "bonds": recording.disk.bond_energy(disk, *bond_law),
        "wall": 0.0,
        "wall lattice": 0.0,
        "load": _weight(recording) * disk[:, 1].mean(),
    }
    kinetic = kinetic_energies(disk, disk_velocity, mass)
    measures.update(zip(MOTIONS, kinetic))
    if "wall" in recording.scene:
        # The potential exp(−a l) holds the force over a, between disks that on either of them.
        sizes = np.hypot(*(0.5 * state.force if recording.hits_disk else disk_force).T)
        measures["wall"] = sizes.sum() / recording.number("wall", "a")
    for body, position, velocity in zip(recording.bodies[1:], others, other_velocities):
        bonds = body.bond_energy(position, *_bond_law(recording, "wall"))
        mass = body.point_mass
        if recording.hits_disk:
            measures["bonds"] += bonds
            for name, energy in zip(MOTIONS, kinetic_energies(position, velocity, mass)):
                measures[name] += energy
        else:
            measures["wall lattice"] = 0.5 * mass * np.sum(velocity**2) + bonds
    return measures


def _weight(recording):
    return recording.number("load", "P", 0.0) + float(recording.scene.get("gravity", 0.0))


def _bond_law(recording, part):
    """k_a and k_b of the disk ("material") or of what it meets, which may have its own."""
    own = recording.scene.get(part) or {}
    return tuple(recording.number(part if own.get(key, "auto") != "auto" else "material", key)
                 for key in ("k_a", "k_b"))
