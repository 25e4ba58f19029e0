#!/usr/bin/python3
"""figure3_demonstration.py PROGRAMS UNDIVIDED [LATTICES] — figure 3 in 16 shards on a Slurm of this
machine, of which one slurmd is killed and brought back, and one task is killed. What is collected is
held against the folder of the same figure undivided."""

import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from loopback_slurm import LoopbackSlurm

PROGRAMS, UNDIVIDED = map(Path, sys.argv[1:3])
LATTICES = sys.argv[3] if len(sys.argv) > 3 else '64'
SHARDS = 16


def without_wall_time(csv):
    """It stands before the flags."""
    return re.sub(r',[^,\n]*,([^,\n]*)\n', r',\1\n', csv)


class Demonstration:
    """Figure 3 on a Slurm."""

    def __init__(self, folder):
        self.begin = time.monotonic()
        (folder / 'slurm').mkdir()
        self.output = folder / 'figure3'
        self.slurm = LoopbackSlurm(folder / 'slurm')

    def tell(self, text):
        """With the time so far."""
        print(f'{time.monotonic() - self.begin:6.0f} s  {text}', flush=True)

    def submit(self):
        """All that is missing."""
        done = subprocess.run(
            [PROGRAMS / 'submit', '--tasks', str(SHARDS), 'reproduce', 'figure3', '--lattices',
             LATTICES, '--output', self.output], check=True, stdout=subprocess.PIPE,
            universal_newlines=True, env=self.slurm.environment)
        for line in done.stdout.splitlines():
            self.tell(line)

    def shards(self):
        """Those that run: (process, K/N)."""
        return [(one, one.words[one.words.index('--shard') + 1])
                for one in self.slurm.processes() if '--shard' in one.words
                and Path(one.words[0]).name == 'reproduce']

    def rows(self):
        """In all files of shards."""
        return sum(max(0, path.read_text().count('\n') - 1)
                   for path in self.output.glob('figure3_shards/*.csv'))

    def kill(self):
        """A slurmd until Slurm gives its node up, and then a task."""
        self.slurm.wait_for(lambda: self.rows() > 0 and len(self.shards()) == 2, 'two tasks')
        one, shard = self.shards()[0]
        self.slurm.kill_node(one.node)
        self.tell(f'killed the slurmd of node {one.node}, which has shard {shard}; '
                  f'{self.rows()} rows so far')
        self.slurm.wait_for(lambda: 'down' in ''.join(self.slurm.states_of_nodes()), 'a node down')
        self.tell('Slurm has given the node up')
        self.slurm.start_node(one.node)
        self.slurm.wait_for(lambda: 'down' not in ''.join(self.slurm.states_of_nodes()),
                            'the node back')
        self.tell('the node is back')
        self.slurm.wait_for(lambda: len(self.shards()) == 2, 'two tasks')
        one, shard = self.shards()[1]
        self.slurm.tell('scancel', '--signal=KILL', '--name=figure3', '--state=RUNNING',
                        f'--nodelist={one.node}')
        self.tell(f'killed shard {shard} by scancel --signal=KILL; {self.rows()} rows so far')

    def wait(self):
        """For the end of all jobs."""
        while self.slurm.tell('squeue', '--noheader'):
            time.sleep(1)
        log = (self.output / 'log' / 'collect.log').read_text().splitlines()
        missing = [line for line in log if 'missing' in line]
        self.tell(f'all jobs have ended, {self.rows()} rows; {missing[0] if missing else "collected"}')

    def compare(self):
        """With the undivided figure; @throw AssertionError."""
        for name in ('figure3_runs.csv', 'figure3.csv', 'figure3_losses.csv', 'figure3_fits.csv'):
            ours, whole = ((folder / name).read_text() for folder in (self.output, UNDIVIDED))
            if name == 'figure3_runs.csv':
                ours, whole = without_wall_time(ours), without_wall_time(whole)
            assert ours == whole, f'{name} differs'
            lines = ours.splitlines()[1:]
            self.tell(f'{name}: {len(lines)} rows, {len(lines) - len(set(lines))} doubled, the '
                      f'bytes of the undivided one{" but for wall_time" * ("_runs" in name)}')


def main():
    """All of it."""
    with tempfile.TemporaryDirectory() as folder:
        demonstration = Demonstration(Path(folder))
        try:
            demonstration.submit()
            demonstration.kill()
            demonstration.wait()
            demonstration.submit()
            demonstration.wait()
            demonstration.compare()
        finally:
            demonstration.slurm.stop()


main()
