#!/usr/bin/python3
"""The viewer draws what is published, live or replayed, and holds nothing up; scalars are what the
other topics say."""

import os
import signal
import tempfile
import threading
import unittest

import genpy.dynamic
import rosgraph
import rospy
import rostest
from lattice_impact.msg import Scalars
from rospkg import RosPack

from programs import (PACKAGE, SMALL_ABSORBING_WALL, TIMEOUT, BagAnalysis, Inbox, bag_messages,
                      bits, launch, poll_until, random_namespace, replay, simulation, viewer)

SCENE = {'disk.points': 60, 'impact.velocity': 0.05, 'output.period': 0.1}
ROUNDING = 1e-12  # of sums over the points, which are taken in another order here


class UnpackingInbox(Inbox):
    """Of messages whose Python packages need not be installed."""

    _generating = threading.Lock()  # genpy is not made for several threads

    def __init__(self, topic):
        self._class = None
        super().__init__(topic, rospy.AnyMsg)

    def _take_in(self, message):
        if self._class is None:
            kind = message._connection_header['type']
            definition = message._connection_header['message_definition']
            with self._generating:
                self._class = genpy.dynamic.generate_dynamic(kind, definition)[kind]
        super()._take_in(self._class().deserialize(message._buff))


def text(array):
    return ''.join(marker.text for marker in array.markers if marker.ns == 'text')


def points(array, name):
    marker, = [m for m in array.markers if m.ns == name and m.type == m.SPHERE_LIST]
    return [(point.x, point.y) for point in marker.points]


def values(diagnostics):
    return {pair.key: pair.value for pair in diagnostics.status[0].values}


class ViewerTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.bag = os.path.join(folder.name, 'run.bag')
        self.folder = folder.name
        self.namespace = random_namespace()

    def simulate(self, scene, values, **parameters):
        with simulation(self.namespace, scene, values, **parameters) as node:
            self.assertEqual(node.wait(), 0, node.stderr())

    def recorded(self, topic):
        return bag_messages(self.bag, self.namespace + '/' + topic)

    def wait_for_viewer(self):
        """Until it would hear a simulation."""
        master = rosgraph.Master('/test')
        poll_until(lambda: self.namespace + '/wall3/particle_states' in
                   dict(master.getSystemState()[1]), 'viewer')

    def test_replay_is_drawn(self):
        self.simulate('absorbing_wall', SMALL_ABSORBING_WALL, bag=self.bag)
        state = self.recorded('particle_states')[-1]
        time = 't = {:.2f} R/c'.format(state.time)
        with viewer(self.namespace), \
                UnpackingInbox(self.namespace + '/markers') as arrays, \
                UnpackingInbox(self.namespace + '/contact_wrench') as wrenches, \
                UnpackingInbox('/diagnostics') as diagnostics:
            self.wait_for_viewer()
            # It stays, since the viewer acknowledges nothing.
            with replay(self.namespace, self.bag, rate=10, wait_for=['viewer'], linger=TIMEOUT):
                last = arrays.wait(lambda array: 'e = ' in text(array) and time in text(array) and
                                   points(array, 'points') == list(zip(state.x, state.y)),
                                   'of the end')
                told = diagnostics.wait(lambda array: values(array).get('progress') == '1', 'of the end')
        self.assertEqual(told.status[0].message, 'run 1 of 1')
        self.assertEqual(values(told)['states published'], str(state.sequence + 1))
        wall = self.recorded('wall/particle_states')[-1]
        self.assertEqual(points(last, 'wall'), list(zip(wall.x, wall.y)))
        forces = {message.total_y for message in self.recorded('contact_forces')}
        drawn = {message.wrench.force.y for message in wrenches.messages()}
        self.assertGreater(len(drawn), 1)
        self.assertLessEqual(drawn, forces)

    def test_run_does_not_wait_for_a_viewer_that_stands_still(self):
        with viewer(self.namespace) as node:
            self.wait_for_viewer()
            node.send(signal.SIGSTOP)
            try:
                self.simulate('collision', SCENE)
            finally:
                node.send(signal.SIGCONT)

    def test_scalars_say_what_the_others_say(self):
        with Inbox(self.namespace + '/scalars', Scalars) as live:
            self.simulate('collision', SCENE, bag=self.bag, wait_for_scalars=[rospy.get_name()])
            scalars = self.recorded('scalars')
            live.wait_for_count(len(scalars))
        for message in live.messages():
            message.header.seq = 0  # that of the publisher
        self.assertEqual(list(map(bits, live.messages())), list(map(bits, scalars)))
        states = self.recorded('particle_states')
        forces = self.recorded('contact_forces')
        self.assertEqual(len(scalars), len(states))
        for scalar, state, force in zip(scalars, states, forces):
            self.assertEqual((scalar.header.stamp, scalar.run, scalar.sequence, scalar.step,
                              scalar.time),
                             (state.header.stamp, state.run, state.sequence, state.step,
                              state.time))
            self.assertEqual((scalar.force_x, scalar.force_y), (force.total_x, force.total_y))
            count = len(state.x)
            self.assertAlmostEqual(scalar.y, sum(state.y) / count, delta=ROUNDING)
            self.assertAlmostEqual(scalar.vy, sum(state.vy) / count, delta=ROUNDING)
            kinetic = sum(u * u + v * v for u, v in zip(state.vx, state.vy)) / (2 * count)
            self.assertAlmostEqual(scalar.kinetic_translation + scalar.kinetic_rotation +
                                   scalar.kinetic_internal, kinetic, delta=ROUNDING)
        end = self.recorded('run_status')[-1].energy
        for name in end.__slots__:
            self.assertEqual(getattr(scalars[-1], name), getattr(end, name), name)

    def launch_with(self, rviz):
        """A launch whose rviz is this script, where the real one is not installed; that one finds
        no display, and fails."""
        package = os.path.join(self.folder, 'rviz')
        os.mkdir(package)
        with open(os.path.join(package, 'package.xml'), 'w') as file:
            file.write('<package><name>rviz</name></package>')
        program = os.path.join(package, 'rviz')
        with open(program, 'w') as file:
            file.write(rviz)
        os.chmod(program, 0o755)
        path = self.folder + ':' + os.environ['ROS_PACKAGE_PATH']
        environment = {'ROS_PACKAGE_PATH': path, 'DISPLAY': ':nowhere',
                       'PYTHONUNBUFFERED': '1'}  # the lines of roslaunch are read as they come
        return launch('collision.launch', environment, ns=self.namespace, bag=self.bag,
                      rviz='true', max_rate=0, N=SCENE['disk.points'],
                      velocity=SCENE['impact.velocity'], period=SCENE['output.period'])

    def test_rviz_that_fails_does_not_end_the_run(self):
        with self.launch_with('#!/bin/sh\nexit 1\n') as run:
            run.wait()
            self.assertIn('recorded 1 run(s)', run.stdout())
        self.assertEqual(BagAnalysis(self.bag).exit_code, 0)

    @unittest.skipIf('rviz' in RosPack().list(), 'rviz is installed, and cannot be feigned')
    def test_launch_stays_until_rviz_is_closed(self):
        closed = os.path.join(self.folder, 'closed')
        script = '#!/bin/sh\nwhile [ ! -e {} ]; do sleep 0.1; done\n'.format(closed)
        with UnpackingInbox(self.namespace + '/markers') as arrays:
            with self.launch_with(script) as run:
                arrays.wait(lambda array: 'e = ' in text(array), 'of the end')
                poll_until(lambda: run.stdout().count('process has finished cleanly') == 3,
                           'end of the run')
                self.assertTrue(run.is_running())
                open(closed, 'w').close()
                run.wait()


if __name__ == '__main__':
    rospy.init_node('viewer_test')
    rostest.rosrun(PACKAGE, 'viewer', ViewerTest)
