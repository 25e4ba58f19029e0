#!/usr/bin/python3
"""What is wrong stops a node at the door: exit code, one line, and nothing left behind."""

import os
import tempfile
import unittest

import rospy
import rostest
from lattice_impact.msg import Acknowledged

from master_witness import MasterWitness
from programs import PACKAGE, SMALL_COLLISION, analysis, random_namespace, simulation


class ParametersTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.namespace = random_namespace()

    def simulate(self, values, environment=None, **parameters):
        parameters = dict({'bag': os.path.join(self.folder, 'run.bag')}, **parameters)
        return simulation(self.namespace, 'collision', dict(SMALL_COLLISION, **values), environment,
                          **parameters)

    def assert_stops_at_the_door(self, start, *words):
        """`start` starts a node in an environment; its line must have each of the words."""
        with MasterWitness() as master, start(master.environment) as process:
            self.assertEqual(process.wait(), 2, process.stderr())
            line, = process.stderr().splitlines()
            for word in words:
                self.assertIn(word, line)
            self.assertEqual(master.published() | master.subscribed(), set())
        self.assertEqual(os.listdir(self.folder), [])

    def assert_simulation_refuses(self, values, *words):
        self.assert_stops_at_the_door(lambda environment: self.simulate(values, environment),
                                      'simulation_node: ', *words)

    def assert_simulation_refuses_own(self, parameters, *words):
        self.assert_stops_at_the_door(
            lambda environment: self.simulate({}, environment, **parameters),
            'simulation_node: ', *words)

    def assert_analysis_refuses(self, parameters, *words):
        self.assert_stops_at_the_door(
            lambda environment: analysis(self.namespace, environment, **parameters),
            'analysis_node: ', *words)

    def test_wrong_type(self):
        self.assert_simulation_refuses({'impact.velocity': 'fast'}, 'impact.velocity', 'fast',
                                       'allowed: number in [1e-09, 1]')

    def test_wrong_type_of_a_parameter_of_the_node(self):
        self.assert_simulation_refuses_own({'max_rate': 'high'}, 'max_rate', 'high',
                                           'allowed: number in [0, ')

    def test_unknown_name(self):
        self.assert_simulation_refuses({'impact.velocty': 0.01}, 'impact.velocty', 'unknown',
                                       'allowed: ', 'impact.velocity', 'impact.gap')

    def test_unknown_name_of_a_parameter_of_the_node(self):
        self.assert_simulation_refuses_own({'max_rat': 50.0}, 'max_rat:', 'unknown', 'allowed: ',
                                           'max_rate', 'wait_for')

    def test_out_of_range(self):
        self.assert_simulation_refuses({'impact.velocity': 2}, 'impact.velocity', 'got 2',
                                       'allowed: number in [1e-09, 1]')

    def test_one_value_of_a_series_out_of_range(self):
        self.assert_simulation_refuses({'impact.velocity': [0.01, 2]}, 'impact.velocity', 'got 2',
                                       'allowed: number in [1e-09, 1]')

    def test_scene_without_motion(self):
        self.assert_stops_at_the_door(
            lambda environment: simulation(self.namespace, 'stretch', {}, environment),
            'simulation_node: ', 'scene: got stretch', 'allowed: contact or collision')

    def test_key_of_an_elastic_wall_without_one(self):
        self.assert_simulation_refuses({'wall.boundary': 'fixed'}, 'wall.boundary', 'unknown')

    def test_step_beyond_the_stability_limit(self):
        self.assert_simulation_refuses({'numerics.step': 1.0}, 'numerics.step', 'got 1',
                                       'allowed: ')

    def test_scene_that_takes_too_long(self):
        self.assert_simulation_refuses({'impact.velocity': [0.01, 1e-9], 'impact.gap': 100.0},
                                       'numerics.longest: this scene would take about ',
                                       '(impact.velocity, impact.gap)', 'at most 3600 s')

    def test_analysis_out_of_range(self):
        self.assert_analysis_refuses({'patience': -1}, 'patience', 'got -1',
                                     'allowed: number in (0')

    def test_analysis_wrong_type(self):
        self.assert_analysis_refuses({'wait_for': 'recorder'}, 'wait_for', 'got "recorder"',
                                     'allowed: list')

    def test_analysis_unknown_name(self):
        self.assert_analysis_refuses({'patiense': 1.0}, 'patiense', 'unknown', 'allowed: ',
                                     'patience')

    def test_bag_that_cannot_be_written(self):
        bag = os.path.join(self.folder, 'missing', 'run.bag')
        self.assert_simulation_refuses_own({'bag': bag}, 'bag: ' + bag + ' cannot be written')

    def test_name_of_a_node_that_no_node_can_have(self):
        self.assert_simulation_refuses_own({'wait_for': ['no-name']}, 'wait_for', 'no-name')

    def assert_misses_subscriber(self, process, topics):
        self.assertEqual(process.wait(), 1)
        line, = process.stderr().splitlines()
        self.assertIn('1 s (timeout)', line)
        for topic in topics:
            self.assertIn('{0}/nobody to {0}/{1}'.format(self.namespace, topic), line)

    def test_simulation_misses_a_subscriber(self):
        with self.simulate({}, bag='', wait_for=['nobody'], timeout=1) as process:
            self.assert_misses_subscriber(
                process, ['lattice', 'particle_states', 'contact_forces', 'run_status'])

    def test_analysis_misses_a_subscriber(self):
        with analysis(self.namespace, wait_for=['nobody'], timeout=1) as process:
            self.assert_misses_subscriber(process, ['strain', 'restitution', 'law_fit'])

    def assert_stops_without_acknowledgement(self, complaint):
        with self.simulate({}, bag='', acknowledged_by=['nobody'], timeout=1) as process:
            self.assertEqual(process.wait(), 1)
            line, = process.stderr().splitlines()
            self.assertIn(complaint, line)

    def test_simulation_misses_an_acknowledging_node(self):
        self.assert_stops_without_acknowledgement(
            'publish on {}/acknowledged within 1 s (timeout)'.format(self.namespace))

    def test_simulation_misses_an_acknowledgement(self):
        silent = rospy.Publisher(self.namespace + '/acknowledged', Acknowledged, queue_size=1)
        self.addCleanup(silent.unregister)
        self.assert_stops_without_acknowledgement(
            self.namespace + '/nobody has acknowledged nothing for 1 s (timeout)')


if __name__ == '__main__':
    rospy.init_node('parameters')
    rostest.rosrun(PACKAGE, 'parameters', ParametersTest)
