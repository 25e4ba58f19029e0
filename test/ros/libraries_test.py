#!/usr/bin/python3
"""The nodes carry the libraries that their work needs, and not those of the other one."""

import re
import subprocess
import unittest

import rostest

from programs import PACKAGE, program


def libraries(name):
    listing = subprocess.check_output(['ldd', program(name)], universal_newlines=True)
    return set(re.findall(r'lib([\w+-]+)\.so', listing))


class LibrariesTest(unittest.TestCase):
    def test_analysis_carries_neither_geometry_nor_bags(self):
        found = libraries('analysis_node')
        self.assertLessEqual({'roscpp', 'gsl'}, found)
        self.assertEqual(found & {'gmp', 'gmpxx', 'mpfr', 'CGAL', 'rosbag', 'rosbag_storage'},
                         set())

    def test_simulation_carries_no_fits(self):
        found = libraries('simulation_node')
        self.assertIn('rosbag_storage', found)
        self.assertEqual(found & {'gsl', 'gslcblas'}, set())


if __name__ == '__main__':
    rostest.rosrun(PACKAGE, 'libraries', LibrariesTest)
