"""A bag of the recorder node."""

import logging
import sys

import numpy as np
import rosbag
import yaml

from .bodies import Body, State
from .history import measure_history
from .program import InputError
from .recording import OTHERS, Recording

STATES = "particle_states"
FORCES = "contact_forces"


class BagRecording(Recording):
    """One run of the series in a bag."""

    def __init__(self, path, run):
        logging.disable(logging.WARNING)  # rosbag's
        try:
            self.bag = rosbag.Bag(str(path))
        except (rosbag.ROSBagException, OSError) as error:
            raise InputError(f"{path}: {error}") from None
        self.topics = self._topics(path)
        statuses = [message for _, message in self._messages("run_status")]
        if not statuses:
            raise InputError(f"{path}: has no run_status")
        self.run = self._choose(path, run, sorted({status.run for status in statuses}))
        self.statuses = sorted((status for status in statuses if status.run == self.run),
                               key=lambda status: status.sequence)
        lattices = {message.name: message
                    for _, message in self._messages(
                        "lattice", *(f"{name}/lattice" for name in OTHERS))
                    if message.run == self.run}
        if "disk" not in lattices:
            raise InputError(f"{path}: has no lattice of run {self.run}")
        names = ["disk", *(name for name in OTHERS if name in lattices)]
        self.prefixes = ["", *(f"{name}/" for name in names[1:])]
        super().__init__(path, yaml.safe_load(self.statuses[0].scene),
                         [body_of(lattices[name]) for name in names])

    def _topics(self, path):
        """Topics by what follows the namespace."""
        topics = self.bag.get_type_and_topic_info().topics
        space = [name[: -len("run_status")] for name, info in topics.items()
                 if info.msg_type == "lattice_impact/RunStatus"]
        if len(space) != 1:
            raise InputError(f"{path}: holds {len(space)} simulations of lattice_impact, not one")
        return {name[len(space[0]):]: name for name in topics if name.startswith(space[0])}

    @staticmethod
    def _choose(path, run, runs):
        if run is None:
            if len(runs) > 1:
                print(f"{path} holds the runs {runs[0]} … {runs[-1]}: the last one is taken, "
                      "--run takes another", file=sys.stderr)
            return runs[-1]
        if run not in runs:
            raise InputError(f"{path}: has no run {run}, only {runs[0]} … {runs[-1]}")
        return run

    def _messages(self, *names):
        """(name, message) of these topics, with arrays for lists of numbers."""
        topics = {self.topics[name]: name for name in names if name in self.topics}
        if not topics:
            return
        for topic, raw, _ in self.bag.read_messages(topics=list(topics), raw=True):
            yield topics[topic], raw[4]().deserialize_numpy(raw[1], np)

    def times(self):
        return np.array([message.time for _, message in self._messages(STATES)
                         if message.run == self.run])

    def states(self):
        """Messages of one state come in any order; a state without one of them is left out."""
        names = [prefix + topic for prefix in self.prefixes for topic in (STATES, FORCES)]
        waiting = {}
        for name, message in self._messages(*names):
            if message.run != self.run:
                continue
            parts = waiting.setdefault(message.sequence, {})
            parts[name] = message
            if len(parts) == len(names):
                yield self._state(waiting.pop(message.sequence))

    def _state(self, parts):
        states = [parts[prefix + STATES] for prefix in self.prefixes]
        forces = [parts[prefix + FORCES] for prefix in self.prefixes]
        position = np.concatenate([np.column_stack((part.x, part.y)) for part in states])
        velocity = np.concatenate([np.column_stack((part.vx, part.vy)) for part in states])
        force = np.zeros_like(position)
        for first_row, part in zip(self.first_rows, forces):
            force[first_row + part.point.astype(int)] = np.column_stack((part.fx, part.fy))
        return State(states[0].step, states[0].time, position, velocity, force)

    def history(self):
        """A status tells the ledger of the latest of the states that it counts."""
        ledgers = [(max(int(status.states) - 1, 0), status.energy) for status in self.statuses]
        return measure_history(self, ledgers)


def body_of(message):
    """A body from its Lattice message."""
    bonds = np.column_stack((message.bond_first, message.bond_second)).astype(int)
    return Body(np.column_stack((message.x, message.y)), bonds, np.array(message.natural_length),
                message.point_mass)
