#!/usr/bin/python3
"""Each program carries the libraries that its work needs, and not those of the others."""

import re
import subprocess
import unittest

import rostest

from programs import PACKAGE, program


def libraries(name):
    listing = subprocess.check_output(['ldd', program(name)], universal_newlines=True)
    return set(re.findall(r'lib([\w+-]+)\.so', listing))


ROS = {'roscpp', 'rosbag', 'rosbag_storage', 'rosconsole', 'rostime', 'xmlrpcpp',
       'roscpp_serialization'}
GEOMETRY = {'CGAL', 'gmp', 'gmpxx', 'mpfr'}
FITS = {'gsl', 'gslcblas'}
BAGS = {'rosbag', 'rosbag_storage'}
SOLVERS = {'sundials_cvode'}


class LibrariesTest(unittest.TestCase):
    def assert_libraries(self, name, needed, not_needed):
        found = libraries(name)
        self.assertLessEqual(needed, found)
        self.assertEqual(found & not_needed, set())

    def test_analysis_carries_neither_geometry_nor_bags_nor_solvers(self):
        self.assert_libraries('analysis_node', {'roscpp', 'gsl'}, GEOMETRY | BAGS | SOLVERS)

    def test_simulation_carries_no_fits(self):
        self.assert_libraries('simulation_node', {'roscpp', 'rosbag_storage', 'gmp'} | SOLVERS, FITS)

    def test_replay_carries_bags_alone(self):
        self.assert_libraries('replay_node', {'roscpp', 'rosbag_storage'}, GEOMETRY | SOLVERS | FITS)

    def test_viewer_carries_what_it_draws_with(self):
        self.assert_libraries('viewer_node', {'roscpp'}, GEOMETRY | BAGS | SOLVERS | FITS)

    def test_bags_are_analysed_without_geometry_and_solvers(self):
        self.assert_libraries('analyse_bag', {'rosbag_storage', 'gsl'}, GEOMETRY | SOLVERS)

    def test_single_runs_and_sweeps_carry_no_ros(self):
        for name in ('impact', 'sweep'):
            with self.subTest(name):
                self.assert_libraries(name, {'gmp', 'yaml-cpp', 'gsl'} | SOLVERS, ROS)

    def test_reproduction_and_measurement_carry_no_ros(self):
        for name in ('reproduce', 'work_precision'):
            with self.subTest(name):
                self.assert_libraries(name, {'gmp', 'yaml-cpp', 'gsl'} | SOLVERS, ROS)


if __name__ == '__main__':
    rostest.rosrun(PACKAGE, 'libraries', LibrariesTest)
