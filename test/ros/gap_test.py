#!/usr/bin/python3
"""The analysis node notices every message that does not reach it, or not as it was."""

import math
import os
import random
import signal
import struct
import tempfile
import unittest

import genpy
import rospy
import rostest
from lattice_impact.msg import ContactForces, Lattice, ParticleStates, RunStatus

from programs import (IMPACT_RESULTS, PACKAGE, SMALL_COLLISION, TIMEOUT, analysis, bag_messages,
                      bits, impact, poll_until, random_namespace, simulation)
from results import Results

TOPICS = {'lattice': Lattice, 'particle_states': ParticleStates, 'contact_forces': ContactForces,
          'run_status': RunStatus}


def record_messages():
    """The messages of a run, by topic, in the order in which they were sent."""
    namespace = random_namespace()
    with tempfile.TemporaryDirectory() as folder:
        bag = os.path.join(folder, 'run.bag')
        with simulation(namespace, 'collision', SMALL_COLLISION, bag=bag) as node:
            node.wait()
        return {name: bag_messages(bag, namespace + '/' + name) for name in TOPICS}


def as_bytes(kind, content):
    """A message that goes over the wire as these bytes."""
    class Bytes(kind):
        def serialize(self, buffer):
            buffer.write(content)
    return Bytes()


def is_message(kind, content, phase):
    """And of this phase: a run whose end is not announced goes on as long as its publisher is there
    (for which a status is not cut, either)."""
    try:
        message = kind().deserialize(content)
    except (genpy.DeserializationError, struct.error):
        return False
    return getattr(message, 'phase', None) == phase


def damaged(message, chance):
    """Cut, or with one byte changed. Bytes of lengths stay: roscpp asks for the memory that a
    message says it needs before it hands it to anybody."""
    kind, content = type(message), bytearray(bits(message))
    if not hasattr(message, 'phase') and chance.random() < 0.2:
        return as_bytes(kind, content[:chance.randrange(len(content))])
    while True:
        changed = bytearray(content)
        changed[chance.randrange(len(content))] ^= chance.randrange(1, 256)
        if is_message(kind, changed, getattr(message, 'phase', None)):
            return as_bytes(kind, changed)


class Sender:
    """Plays the part of the simulation node, to one analysis node."""

    def __init__(self, namespace):
        self._publishers = {name: rospy.Publisher(namespace + '/' + name, kind, queue_size=0)
                            for name, kind in TOPICS.items()}

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for publisher in self._publishers.values():
            publisher.unregister()

    def send(self, messages):
        """One topic after the other, once the node has subscribed to all."""
        poll_until(lambda: all(publisher.get_num_connections() == 1
                               for publisher in self._publishers.values()), 'subscription')
        for name, publisher in self._publishers.items():
            for message in messages[name]:
                publisher.publish(message)


class GapTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.sent = record_messages()

    def setUp(self):
        self.namespace = random_namespace()

    def without(self, name, sequence):
        rest = [message for message in self.sent[name] if message.sequence != sequence]
        self.assertEqual(len(rest), len(self.sent[name]) - 1)
        return dict(self.sent, **{name: rest})

    def analyse(self, messages, exit_code, patience=TIMEOUT):
        """The last result, and what the node complained of."""
        result, code, complaint = self.outcome(messages, patience)
        self.assertEqual(code, exit_code, complaint)
        return result, complaint

    def outcome(self, messages, patience):
        with Results(self.namespace) as results:
            with analysis(self.namespace, wait_for=[rospy.get_name()], patience=patience,
                          exit_when_done=True) as node:
                with Sender(self.namespace) as sender:
                    sender.send(messages)
                    result = results.final_restitution()
                return result, node.wait(), node.stderr()

    def assert_incomplete(self, result):
        self.assertTrue(result.ended)
        self.assertFalse(result.complete)
        self.assertIn('incomplete', result.flags)
        self.assertTrue(math.isnan(result.restitution))

    def test_nothing_missing(self):
        result, complaint = self.analyse(self.sent, exit_code=0)
        self.assertTrue(result.complete)
        self.assertEqual(result.flags, [])
        self.assertEqual(result.restitution,
                         impact('collision', SMALL_COLLISION)['restitution'])
        self.assertEqual(complaint, '')

    def test_damaged_messages(self):
        truth, _ = self.analyse(self.sent, exit_code=0)
        seed = random.randrange(2 ** 32)
        for chance in (random.Random(seed + k) for k in range(8)):
            self.namespace = random_namespace()
            messages = {name: list(of_topic) for name, of_topic in self.sent.items()}
            names = chance.choices(list(TOPICS), k=chance.randrange(1, 4))
            places = {(name, chance.randrange(len(messages[name]))) for name in names}
            for name, place in sorted(places):
                messages[name][place] = damaged(messages[name][place], chance)
            result, code, complaint = self.outcome(messages, patience=1.0)
            told = 'seed {}, exit code {}: {}'.format(seed, code, complaint)
            self.assertIn(code, (0, 1), told)
            if code == 0:
                for name in IMPACT_RESULTS:
                    self.assertEqual(getattr(result, name), getattr(truth, name), told)
            else:
                self.assertTrue(complaint)

    def test_state_missing(self):
        result, complaint = self.analyse(self.without('particle_states', 100), exit_code=1)
        self.assert_incomplete(result)
        self.assertIn('run 0: messages are missing: expected sequence 100, got 101', complaint)

    def test_first_contact_forces_missing(self):
        result, complaint = self.analyse(self.without('contact_forces', 0), exit_code=1)
        self.assert_incomplete(result)
        self.assertIn('run 0: messages are missing: expected sequence 0, got 1', complaint)

    def test_last_state_missing(self):
        last = self.sent['particle_states'][-1].sequence
        result, complaint = self.analyse(self.without('particle_states', last), exit_code=1,
                                         patience=2.0)
        self.assert_incomplete(result)
        self.assertIn('run 0: incomplete after {} states of {}'.format(last, last + 1), complaint)

    def test_lattice_missing(self):
        result, complaint = self.analyse(dict(self.sent, lattice=[]), exit_code=1, patience=2.0)
        self.assert_incomplete(result)
        self.assertIn('run 0: incomplete after 0 states', complaint)

    def test_end_not_announced(self):
        last = self.sent['run_status'][-1].sequence
        states = self.sent['particle_states']
        with Results(self.namespace) as results, Sender(self.namespace) as sender:
            with analysis(self.namespace, wait_for=[rospy.get_name()]) as node:
                sender.send(self.without('run_status', last))
                results.strain.wait_for_count(len(states))
                node.send(signal.SIGINT)
                self.assertEqual(node.wait(), 1)
                self.assert_incomplete(results.final_restitution())
                self.assertIn('its end was not announced', node.stderr())


if __name__ == '__main__':
    rospy.init_node('gap')
    rostest.rosrun(PACKAGE, 'gap', GapTest)
