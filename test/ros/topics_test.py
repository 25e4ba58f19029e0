#!/usr/bin/python3
"""The nodes have the topics that their work needs, and no others."""

import signal
import unittest

import rospy
import rostest

from master_witness import MasterWitness
from programs import (PACKAGE, SMALL_ABSORBING_WALL, SMALL_COLLISION, SMALL_CONTACT, TIMEOUT,
                      analysis, random_namespace, simulation, viewer)

OF_EVERY_NODE = {'/rosout'}
SIMULATION = ('lattice', 'particle_states', 'contact_forces', 'run_status', 'scalars')
WALL = ('wall/lattice', 'wall/particle_states', 'wall/contact_forces')
ANALYSIS = ('strain', 'restitution', 'law_fit', 'acknowledged')


class TopicsTest(unittest.TestCase):
    def setUp(self):
        self.namespace = random_namespace()

    def absolute(self, names):
        return {self.namespace + '/' + name for name in names}

    def topics_of_simulation(self, scene, values, exit_code=0, **parameters):
        with MasterWitness() as master:
            with simulation(self.namespace, scene, values, master.environment,
                            **parameters) as node:
                self.assertEqual(node.wait(), exit_code, node.stderr())
            return master.published(), master.subscribed()

    def assert_simulation_topics(self, topics, more_published=(), more_subscribed=()):
        published, subscribed = topics
        self.assertEqual(published, OF_EVERY_NODE | self.absolute(SIMULATION) |
                         set(more_published))
        self.assertEqual(subscribed, set(more_subscribed))

    def test_collision(self):
        self.assert_simulation_topics(self.topics_of_simulation('collision', SMALL_COLLISION))

    def test_absorbing_wall(self):
        topics = self.topics_of_simulation('absorbing_wall', SMALL_ABSORBING_WALL)
        self.assert_simulation_topics(topics, more_published=self.absolute(WALL))

    def test_contact(self):
        self.assert_simulation_topics(self.topics_of_simulation('contact', SMALL_CONTACT))

    def test_clock(self):
        topics = self.topics_of_simulation('collision', SMALL_COLLISION, publish_clock=True)
        self.assert_simulation_topics(topics, more_published=['/clock'])

    def test_acknowledged(self):
        topics = self.topics_of_simulation('collision', SMALL_COLLISION, exit_code=1, timeout=0.1,
                                           acknowledged_by=['nobody'])
        self.assert_simulation_topics(topics, more_subscribed=self.absolute(['acknowledged']))

    def test_viewer(self):
        with MasterWitness() as master:
            with viewer(self.namespace, master.environment) as node:
                master.wait_for_subscriber(self.namespace + '/wall3/particle_states', TIMEOUT)
                node.send(signal.SIGINT)
                self.assertEqual(node.wait(), 0, node.stderr())
            self.assertEqual(master.published(), OF_EVERY_NODE | {'/tf_static', '/diagnostics'} |
                             self.absolute(['markers', 'contact_wrench']))
            self.assertEqual(master.subscribed(), self.absolute(
                ['contact_forces', 'run_status',
                 *(body + topic for body in ('', 'wall/', 'wall2/', 'wall3/')
                   for topic in ('lattice', 'particle_states'))]))

    def test_analysis(self):
        with MasterWitness() as master:
            with analysis(self.namespace, master.environment) as node:
                master.wait_for_subscriber(self.namespace + '/run_status', TIMEOUT)
                node.send(signal.SIGINT)
                node.wait()
            self.assertEqual(master.published(), OF_EVERY_NODE | self.absolute(ANALYSIS))
            self.assertEqual(master.subscribed(), self.absolute(
                ['lattice', 'particle_states', 'contact_forces', 'run_status']))


if __name__ == '__main__':
    rospy.init_node('topics')
    rostest.rosrun(PACKAGE, 'topics', TopicsTest)
