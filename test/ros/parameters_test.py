#!/usr/bin/python3
"""What is wrong stops a node at the door: exit code, one line, and nothing left behind."""

import os
import shutil
import socket
import tempfile
import unittest

import rospy
import rostest
from lattice_impact.msg import Acknowledged
from rospkg import RosPack

from master_witness import MasterWitness
from programs import (PACKAGE, SMALL_COLLISION, Process, analysis, launch, node, program,
                      random_namespace, scene_file, simulation)


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
        self.assert_simulation_refuses({'impact.velocity': [0.01, 1e-9], 'impact.gap': 100.0,
                                        'numerics.integrator': 'verlet'},
                                       'numerics.longest: this scene would take about ',
                                       '(numerics.integrator, impact.velocity, impact.gap)', 'at most 3600 s')

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

    def test_text_of_a_scene_and_assignments(self):
        self.assert_stops_at_the_door(
            lambda environment: node(
                'simulation_node', self.namespace + '/simulation',
                {'scene_yaml': 'scene: collision\nseed: 0100\n', 'assignments': ['disk.points=9']},
                environment),
            'simulation_node: seed: got 0100')
        self.assert_simulation_refuses_own({'assignments': ['impact.velocity=7']},
                                           'impact.velocity: got 7')
        self.assert_simulation_refuses_own({'scene_yaml': 'a: 1\n---\n'}, 'scene_yaml: allowed: one YAML document')

    def assert_ends_without_master(self, *arguments, uri='http://localhost:1'):
        for name in ('simulation_node', 'analysis_node', 'recorder_node', 'replay_node'):
            with Process([program(name), *arguments], {'ROS_MASTER_URI': uri}) as process:
                self.assertNotEqual(process.wait(), 0)
                line, = process.stderr().splitlines()
                self.assertIn(name + ': ', line)
                self.assertIn('ROS master', line)

    def test_no_master(self):
        self.assert_ends_without_master()
        self.assert_ends_without_master('_bag:=x.bag')
        self.assert_ends_without_master('__master:=nowhere', '_bag:=x.bag')
        self.assert_ends_without_master(uri='')

    def assert_launch_refuses(self, file, *words, environment=None, **arguments):
        with launch(file, environment, **arguments) as process:
            self.assertEqual(process.wait(), 2, process.stderr())
            line, = process.stderr().splitlines()
            self.assertIn(file + ': ', line)
            for word in words:
                self.assertIn(word, line)
            self.assertNotIn('started roslaunch server', process.stdout())

    def test_launch_arguments(self):
        self.assert_launch_refuses('collision.launch', 'velocty: unknown argument (did you mean velocity?), allowed: ',
                                   'velocity', velocty=0.1)
        self.assert_launch_refuses('contact.launch', 'load.P: got 7, allowed: number in', P=7)
        self.assert_launch_refuses('absorbing_wall.launch', 'wall.boundary: got soft',
                                   boundary='soft')
        self.assert_launch_refuses('collision.launch', 'bag: got nothing, allowed: a file', bag='')
        self.assert_launch_refuses('collision.launch', 'bag: there is no folder /nowhere',
                                   bag='/nowhere/run.bag')
        self.assert_launch_refuses('collision.launch', 'none.yaml: cannot be read',
                                   scene='none.yaml')
        self.assert_launch_refuses('collision.launch', 'record: got maybe', record='maybe')
        self.assert_launch_refuses('collision.launch', 'rviz: got maybe', rviz='maybe')

    def test_launch_with_a_view_that_cannot_be_shown(self):
        """Whether rviz is installed or not."""
        for file in ('collision.launch', 'replay.launch'):
            self.assert_launch_refuses(
                file, *(['DISPLAY is not set'] if 'rviz' in RosPack().list() else
                        ['rviz: not installed', 'package rviz']),
                environment={'DISPLAY': ''}, rviz='true')

    def test_launch_with_a_view_whose_node_is_not_built(self):
        """From a copy of the package that has no programs, beside an rviz by name only."""
        package = os.path.join(self.folder, PACKAGE)
        shutil.copytree(os.path.join(RosPack().get_path(PACKAGE), 'launch'),
                        os.path.join(package, 'launch'))
        for name in (PACKAGE, 'rviz'):
            os.makedirs(os.path.join(self.folder, name), exist_ok=True)
            with open(os.path.join(self.folder, name, 'package.xml'), 'w') as file:
                file.write('<package><name>{}</name></package>'.format(name))
        path = self.folder + ':' + os.environ['ROS_PACKAGE_PATH']
        for file in ('collision.launch', 'replay.launch'):
            self.assert_launch_refuses(
                file, 'rviz: viewer_node is not built; install lib', ' and build again',
                environment={'ROS_PACKAGE_PATH': path, 'CMAKE_PREFIX_PATH': '/usr'}, rviz='true')

    def test_launch_of_a_replay(self):
        bag = os.path.join(self.folder, 'run.bag')
        self.assert_launch_refuses('replay.launch', 'bag: got nothing')
        self.assert_launch_refuses('replay.launch', bag + ': No such file', bag=bag)
        with open(bag, 'w') as file:
            file.write('no bag')
        self.assert_launch_refuses('replay.launch', bag + ' is no bag, or damaged: ', bag=bag)
        with self.simulate({}) as process:
            self.assertEqual(process.wait(), 0, process.stderr())
        self.assert_launch_refuses('replay.launch', 'ns: got lattice_impact, allowed: ',
                                   self.namespace, bag=bag)

    def test_launch_with_a_value_that_a_node_refuses(self):
        bag = os.path.join(self.folder, 'run.bag')
        for name, value in (('max_rate', 'high'), ('timeout', -1), ('publish_clock', 'often'),
                            ('young_modulus', 'soft'), ('poisson_ratio', 2)):
            self.assert_launch_refuses('collision.launch', '{}: got '.format(name), bag=bag,
                                       **{name: value})
        for name, value in (('rate', 0), ('linger', 'long'), ('wait_for', 'a b')):
            self.assert_launch_refuses('replay.launch', '{}: got '.format(name), bag=bag,
                                       **{name: value})
        self.assertEqual(os.listdir(self.folder), [])

    def test_launch_of_a_node_that_fails(self):
        """Its line, an end in order, and no master left over."""
        port = '11399'
        scene = os.path.join(self.folder, 'scene.yaml')
        with open(scene_file('absorbing_wall')) as file:
            text = file.read()
        with open(scene, 'w') as file:
            file.write(text.replace('threshold: 0.2', 'threshold: 0.02'))
        for _ in range(3):
            with Process(['roslaunch', '-p', port, PACKAGE, 'absorbing_wall.launch',
                          'record:=false', 'N:=28', 'scene:=' + scene]) as process:
                process.wait()
                self.assertIn('the energy balance broke', process.stderr())
                self.assertNotIn('RLException', process.stderr())
        with self.assertRaises(OSError):
            socket.create_connection(('localhost', int(port)))

    def test_simulated_time_without_a_clock(self):
        rospy.set_param('/use_sim_time', True)
        self.addCleanup(rospy.delete_param, '/use_sim_time')
        with self.simulate({}) as process:
            self.assertEqual(process.wait(), 0)
            self.assertIn('nobody publishes /clock', process.stderr() + process.stdout())

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
