#!/usr/bin/python3
"""submit_test.py PROGRAMS — what submit does before Slurm has a say."""

import re
import subprocess
import sys
import unittest
from pathlib import Path

PROGRAMS = Path(sys.argv.pop(1))


class Submit(unittest.TestCase):
    def test_bad_input_is_refused_in_a_line(self):
        for words, reason in ((['swep'], 'got swep, allowed: sweep or reproduce'),
                              ([], 'got no program'),
                              (['--tasks', '0', 'sweep'], 'allowed: a whole number from 1 on'),
                              (['sweep', 'collision'], 'required: --output'),
                              (['sweep', 'collision', 'eta=', '--output', 'x'], 'material.eta: '),
                              (['sweep', 'collision', '--shard', '1/2', '--output', 'x'],
                               '--shard: submit adds it')):
            done = subprocess.run([PROGRAMS / 'submit', *words], stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, universal_newlines=True, check=False)
            self.assertEqual(done.returncode, 2, done.stdout)
            self.assertRegex(done.stdout, rf'\A[a-z]+: .*{re.escape(reason)}.*\n\Z')
            self.assertFalse(Path('x').exists())


if __name__ == '__main__':
    unittest.main()
