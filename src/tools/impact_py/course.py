"""The figure of one run: compression, wall force, velocity of the centre of mass, energies."""

import numpy as np

from .history import ENERGIES
from .program import InputError
from .style import (BLACK, BLUE, GREEN, GREY, ORANGE, PURPLE, SKY, TWO_COLUMNS, VERMILION, letter,
                    panels)

COLOURS = dict(zip(ENERGIES, (BLUE, SKY, "#a8d5f0", GREEN, ORANGE, "#8c6d1f", GREY, VERMILION,
                              PURPLE, BLACK)))
SMALLEST_SHARE = 1e-4  # of the largest sum; what is always below it is not drawn


def energy_layers(history):
    """(name, energies) of what can be seen, bottom first. Potential energy of a load counts from
    its lowest."""
    energies = dict(history.energies)
    energies["load"] = energies["load"] - energies["load"].min()
    largest = max(np.max(sum(energies.values())), np.finfo(float).tiny)
    return [(name, energies[name]) for name in ENERGIES
            if np.max(np.abs(energies[name])) > SMALLEST_SHARE * largest]


def percentage(share):
    """As a text; what is next to nothing is said to be so."""
    return f"{100 * share:.3g} %" if abs(share) >= 1e-5 else "< 0.001 %"


def draw_energies(ax, history):
    """One on the other; the legend says which part of the sum each has at the end."""
    layers = energy_layers(history)
    sum_at_end = sum(energy[-1] for _, energy in layers)
    low = np.zeros_like(history.time)
    for name, energy in layers:
        ax.fill_between(history.time, low, low + energy, color=COLOURS[name], linewidth=0.2,
                        label=f"{name}, {percentage(energy[-1] / sum_at_end)}")
        low = low + energy
    ax.set_ylim(0, 1.02 * low.max())
    ax.set_ylabel("energy $(M c^2)$")
    handles, labels = ax.get_legend_handles_labels()
    ax.legend(handles[::-1], labels[::-1], loc="upper left", bbox_to_anchor=(1.02, 1.0),
              title="energy, share at the end", alignment="left")


def draw_course(history, title):
    """The figure of a run."""
    if len(history.time) < 3:
        raise InputError("the run has no course to draw: it was solved without motion")
    figure, axes = panels(TWO_COLUMNS, 0.62 * TWO_COLUMNS, rows=2, columns=2, sharex=True)
    (strain, energies), (force, velocity) = axes
    figure.suptitle(title, fontsize=8)
    strain.plot(history.time, history.strain, color=BLUE)
    strain.set_ylabel(r"compression $\xi$ $(R)$")
    force.plot(history.time, history.force, color=BLUE)
    force.set_ylabel("wall force $(M c^2/R)$")
    sideways, normal = history.velocity.T
    velocity.axhline(0, color=GREY, linewidth=0.5)
    velocity.plot(history.time, normal, color=BLUE, label="across the wall")
    if np.max(np.abs(sideways)) > 1e-3 * np.max(np.abs(normal)):
        velocity.plot(history.time, sideways, "--", color=VERMILION, label="along the wall")
        velocity.legend(loc="upper left", bbox_to_anchor=(1.02, 1.0))
    velocity.set_ylabel("velocity of the centre $(c)$")
    draw_energies(energies, history)
    for ax in (force, velocity):
        ax.set_xlabel("time $(R/c)$")
        ax.set_xlim(history.time[0], history.time[-1])
    for ax in axes.flat:
        ax.ticklabel_format(axis="y", scilimits=(-2, 3), useMathText=True)
    letter((strain, energies, force, velocity))
    return figure


def title_of(recording):
    """What distinguishes the run, in one line."""
    scene = recording.scene
    parts = [str(scene.get("scene", "")), f"$N = {len(recording.disk.points)}$"]
    parts.append(rf"$\eta^* = {recording.number('material', 'eta'):g}$")
    if "impact" in scene:
        parts.append(f"$v = {recording.number('impact', 'velocity'):g}\\,c$")
        angle, spin = (recording.number("impact", key, 0.0) for key in ("angle", "spin"))
        if angle:
            parts.append(rf"$\gamma = {angle:g}°$")
        if spin:
            parts.append(rf"$\omega = {spin:g}\,c/R$")
    if "load" in scene:
        parts.append(f"$P = {recording.number('load', 'P'):g}\\,M c^2/R$")
    if recording.has_elastic_wall:
        parts.append("elastic wall")
    if recording.hits_disk:
        parts.append(f"{len(recording.bodies)} disks")
    return ", ".join(parts)
