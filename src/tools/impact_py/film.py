"""A film of one run: bonds coloured by their strain, the forces of the contact as arrows."""

import math
from dataclasses import dataclass

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.animation import FFMpegWriter, PillowWriter

from .lattice_drawing import LatticeDrawing, strain_bar, strain_limit
from .program import unfinished
from .style import BLACK

SIZE = 5.0  # inches


@dataclass
class Kind:
    """How films with one ending are made. A .gif is large, so it has fewer and smaller frames."""

    writer: type
    frames_per_second: int
    most_frames: int
    dots_per_inch: int


KINDS = {".mp4": Kind(FFMpegWriter, 25, 200, 144), ".gif": Kind(PillowWriter, 12, 90, 100)}


def chosen_states(recording, most):
    """At most so many states, evenly over the run, first and last included."""
    count = len(recording.times())
    wanted = set(np.linspace(0, count - 1, min(count, most)).round().astype(int))
    return [state for number, state in enumerate(recording.states()) if number in wanted]


class Film:
    """The figure and what moves in it."""

    def __init__(self, recording, states):
        self.recording = recording
        self.strains = [recording.strains(state) for state in states]
        disk = recording.disk_rows
        peak = max(np.max(np.hypot(*state.force[:disk].T)) for state in states)
        self.figure, self.ax = plt.subplots(figsize=(SIZE, SIZE), constrained_layout=True)
        bonds = recording.bonds()
        thick_if_few = min(1.5, 0.7 * math.sqrt(3000 / len(bonds)))
        self.drawing = LatticeDrawing(self.ax, bonds, strain_limit(np.concatenate(self.strains)),
                                      peak, thick_if_few)
        strain_bar(self.figure, self.drawing, self.ax)
        self.ax.set_xlabel("$x/R$")
        self.ax.set_ylabel("$y/R$")
        self._set_limits(np.concatenate([state.position for state in states]))
        speed = max(abs(state.velocity[:disk, 1].mean()) for state in states)
        self.decimals = max(0, 2 - math.floor(math.log10(speed))) if speed > 0 else 1
        self.show(0, states[0])
        self.figure.draw_without_rendering()
        self.figure.set_layout_engine("none")  # it would take half of the time

    def _set_limits(self, positions):
        low, high = positions.min(axis=0) - 0.1, positions.max(axis=0) + 0.1
        self.ax.set_xlim(low[0], high[0])
        if "wall" in self.recording.scene and len(self.recording.bodies) == 1:
            low[1] = min(low[1], -0.1)
            self.ax.axhspan(low[1], 0, facecolor="0.85", edgecolor=BLACK, linewidth=0.8, zorder=0)
        self.ax.set_ylim(low[1], high[1])

    def show(self, number, state):
        """Moves everything to this state."""
        disk = self.recording.disk_rows
        force = state.force.copy()
        force[disk:] = 0.0
        self.drawing.show(state.position, self.strains[number], force)
        velocity = state.velocity[:disk, 1].mean()
        speed = f"{velocity:.{self.decimals}f}"
        self.ax.set_title(f"$t = {state.time:.2f}\\,R/c$,   $v = {speed}\\,c$", fontsize=9)


def write_film(recording, path):
    """The film of a recording, as .mp4 or .gif."""
    kind = KINDS[path.suffix]
    states = chosen_states(recording, kind.most_frames)
    film = Film(recording, states)
    writer = kind.writer(fps=kind.frames_per_second)
    with unfinished(path) as beside, writer.saving(film.figure, str(beside), kind.dots_per_inch):
        for number, state in enumerate(states):
            film.show(number, state)
            writer.grab_frame()
    plt.close(film.figure)
