#!/usr/bin/python3
"""plot_impact and convert on a recorded bag, started by rosrun."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np
import rospy
import rostest

from programs import (PACKAGE, SMALL_ABSORBING_WALL, TIMEOUT, program, random_namespace, run_tool,
                      scene_file, simulation, without_module)

sys.path.insert(0, str(Path(program('convert')).parent))
from impact_py.recording import open_recording


def rosrun(*words, **environment):
    """With nobody who could choose among several programs of that name."""
    return subprocess.run(['rosrun', PACKAGE, *words], stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          env=dict(os.environ, **environment), universal_newlines=True,
                          timeout=TIMEOUT)


class PythonProgramsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.directory = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.directory.cleanup)
        cls.folder = Path(cls.directory.name)
        cls.bag = cls.folder / 'run.bag'
        with simulation(random_namespace(), 'absorbing_wall',
                        dict(SMALL_ABSORBING_WALL, seed=[4, 5]), bag=str(cls.bag)) as node:
            if node.wait() != 0:
                raise AssertionError(node.stderr())
        cls.output = cls.folder / 'run'
        done = run_tool('impact', scene_file('absorbing_wall'), 'seed=5', '--output',
                        str(cls.output), '--states',
                        *(f'{key}={value}' for key, value in SMALL_ABSORBING_WALL.items()))
        if done.returncode != 0:
            raise AssertionError(done.stderr)

    def test_bag_has_the_states_of_the_folder(self):
        """The last run of the series, bit by bit."""
        bag, folder = open_recording(self.bag), open_recording(self.output)
        for of_bag, of_folder in zip(bag.bodies, folder.bodies):
            np.testing.assert_array_equal(of_bag.points, of_folder.points)
            np.testing.assert_array_equal(of_bag.bonds, of_folder.bonds)
        states = list(bag.states())
        self.assertEqual(len(states), len(folder.times()))
        for one, other in zip(states, folder.states()):
            self.assertEqual((one.step, one.time), (other.step, other.time))
            for name in ('position', 'velocity', 'force'):
                np.testing.assert_array_equal(getattr(one, name), getattr(other, name), name)

    def test_bag_has_the_history_of_the_folder(self):
        """Energies from the states, and where that is not possible from the ledgers between."""
        bag, folder = open_recording(self.bag).history(), open_recording(self.output).history()
        impact = folder.energies['translation'][0]
        np.testing.assert_array_equal(bag.time, folder.time)
        np.testing.assert_allclose(bag.strain, folder.strain, atol=1e-13)
        for name, energy in folder.energies.items():
            # Forces below 1e-6 of the velocity are not in the bag; the step's error goes to
            # what is absorbed.
            np.testing.assert_allclose(bag.energies[name], energy, atol=1e-3 * impact, err_msg=name)
        self.assertGreater(folder.energies['absorbed'][-1], 0.01 * impact)

    def test_run_of_a_series_is_chosen(self):
        first, last = open_recording(self.bag, 0), open_recording(self.bag, 1)
        self.assertEqual((first.scene['seed'], last.scene['seed']), (4, 5))
        self.assertFalse(np.array_equal(first.disk.points, last.disk.points))
        done = rosrun('convert', str(self.bag), 'npz', '--run', '2')
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stdout, f'convert: {self.bag}: has no run 2, only 0 … 1\n')

    def test_rosrun_finds_each_program_once(self):
        path = self.folder / 'a.svg'
        done = rosrun('plot_impact', str(self.bag), '--run', '0', '--output', str(path))
        self.assertEqual((done.returncode, done.stdout), (0, f'{path}\n'))
        for name in ('convert', 'plot_figures', 'plot_sweep'):
            done = rosrun(name, '--help')
            self.assertEqual(done.returncode, 0, done.stdout)
            self.assertTrue(done.stdout.startswith(f'usage: {name} '), done.stdout)

    def test_bag_without_rosbag_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            environment = without_module('rosbag', folder)
            for words in (['convert', str(self.bag), 'npz'], ['plot_impact', str(self.bag)]):
                done = rosrun(*words, **environment)
                self.assertEqual((done.returncode, done.stdout), (
                    1, f"{words[0]}: No module named 'rosbag'; install python3-rosbag\n"))

    def test_damaged_bag_is_refused(self):
        broken = self.folder / 'broken.bag'
        broken.write_bytes(self.bag.read_bytes()[:5000])
        done = rosrun('plot_impact', str(broken))
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stdout, r'\Aplot_impact: .*broken\.bag: .*\n\Z')
        self.assertEqual([name for name in os.listdir(self.folder) if 'broken' in name],
                         ['broken.bag'])


if __name__ == '__main__':
    rospy.init_node('python_programs_test')
    rostest.rosrun(PACKAGE, 'python_programs', PythonProgramsTest)
