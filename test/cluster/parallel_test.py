#!/usr/bin/python3
"""parallel_test.py PROGRAMS — GNU Parallel gives the shards of a sweep to machines, of which there is
one here."""

import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from small_sweep import SWEEP, without_wall_time

PROGRAMS = Path(sys.argv.pop(1))


@unittest.skipUnless(shutil.which('parallel'), 'parallel is not installed; test/run.sh --cluster')
class Parallel(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.folder = Path(directory.name)

    def run_quietly(self, *words):
        done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, universal_newlines=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout)
        return done.stdout

    def test_shards_are_the_undivided_sweep(self):
        sweep = [PROGRAMS / 'sweep', *SWEEP, '--output']
        shards = self.folder / 'shards'
        told = self.run_quietly('parallel', '--sshlogin', ':,2/:', *sweep, shards, '--jobs', 1,
                                '--shard', '{}/5', ':::', *range(1, 6))
        self.assertEqual(sorted(line for line in told.splitlines() if line.startswith('shard')),
                         [f'shard {k}/5: 8 runs done' for k in range(1, 6)])
        self.run_quietly(*sweep, shards, '--collect', self.folder / 'collected.csv')
        self.run_quietly(*sweep, self.folder / 'whole.csv')
        collected, whole = (without_wall_time((self.folder / name).read_text())
                            for name in ('collected.csv', 'whole.csv'))
        self.assertEqual(collected, whole)


if __name__ == '__main__':
    unittest.main()
