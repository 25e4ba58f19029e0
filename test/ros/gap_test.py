#!/usr/bin/python3
"""The analysis node notices every message that does not reach it."""

import math
import os
import signal
import tempfile
import unittest

import rospy
import rostest
from lattice_impact.msg import ContactForces, Lattice, ParticleStates, RunStatus

from programs import (PACKAGE, SMALL_COLLISION, TIMEOUT, analysis, bag_messages, impact,
                      poll_until, random_namespace, simulation)
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
        with Results(self.namespace) as results:
            with analysis(self.namespace, wait_for=[rospy.get_name()], patience=patience,
                          exit_when_done=True) as node:
                with Sender(self.namespace) as sender:
                    sender.send(messages)
                    result = results.final_restitution()
                self.assertEqual(node.wait(), exit_code, node.stderr())
                return result, node.stderr()

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
