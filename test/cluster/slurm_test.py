#!/usr/bin/python3
"""slurm_test.py PROGRAMS — submit on a real Slurm of this machine: what is collected is what one
sweep writes, whatever happens to nodes and tasks."""

import os
import re
import signal
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import loopback_slurm
from loopback_slurm import LoopbackSlurm
from small_sweep import RUNS, SWEEP, without_wall_time

PROGRAMS = Path(sys.argv.pop(1))
TASKS = 4


class OnSlurm(unittest.TestCase):
    """A test with a Slurm of its own."""

    options = {}

    @classmethod
    def setUpClass(cls):
        if not loopback_slurm.is_installed():
            raise unittest.SkipTest('slurm-wlm and munge are not installed; test/run.sh --cluster')
        directory = tempfile.TemporaryDirectory()
        cls.addClassCleanup(directory.cleanup)
        whole = Path(directory.name) / 'whole.csv'
        subprocess.run([PROGRAMS / 'sweep', *SWEEP, '--output', whole], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        cls.whole = without_wall_time(whole.read_text())
        assert cls.whole.count('\n') == 1 + RUNS

    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        folder = Path(directory.name)
        self.output = folder / 'a sweep'
        (folder / 'slurm').mkdir()
        self.slurm = LoopbackSlurm(folder / 'slurm', **self.options)
        self.addCleanup(self.slurm.stop)

    def run_program(self, *words):
        return subprocess.run([str(PROGRAMS / words[0]), *words[1:]], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, universal_newlines=True, check=False,
                              env=self.slurm.environment)

    def try_to_submit(self, *options):
        return self.run_program('submit', *options, 'sweep', *SWEEP, '--output', str(self.output))

    def submit(self, *options):
        done = self.try_to_submit(*(options or ['--tasks', str(TASKS)]))
        self.assertEqual(done.returncode, 0, done.stdout)
        return done.stdout

    def rows(self, shard, count=TASKS):
        """How many the file of this shard has."""
        path = self.output / f'shard-{shard}-of-{count}.csv'
        return max(0, path.read_text().count('\n') - 1) if path.exists() else 0

    def sweeps(self):
        """Those that run, and their shards."""
        return [(one, int(one.words[one.words.index('--shard') + 1].partition('/')[0]))
                for one in self.slurm.processes() if Path(one.words[0]).name == 'sweep'
                and '--shard' in one.words]

    def stopped_sweep(self):
        """One in the middle of its rows, which SIGSTOP keeps there, and its shard."""
        found = []

        def stopped():
            for sweep, shard in self.sweeps():
                os.kill(sweep.pid, signal.SIGSTOP)
                if 0 < self.rows(shard) < RUNS / TASKS:
                    found.append((sweep, shard))
                    return True
                os.kill(sweep.pid, signal.SIGCONT)
            return False

        self.slurm.wait_for(stopped, 'a sweep in the middle of its rows')
        return found[0]

    def restarts(self):
        """Of all tasks that Slurm remembers."""
        return sum(map(int, re.findall(r'Restarts=(\d+)', self.slurm.tell('scontrol', 'show', 'job'))))

    def log(self, name):
        return (self.output / 'log' / name).read_text()

    def assert_collected(self):
        self.slurm.wait_for_end()
        table = self.output / 'sweep.csv'
        self.assertTrue(table.exists(), self.log('collect.log'))
        self.assertEqual(without_wall_time(table.read_text()), self.whole)


class Submit(OnSlurm):
    def test_array_is_collected(self):
        self.assertIn(f': {TASKS} of {TASKS} shards', self.submit())
        self.assertRegex(self.try_to_submit().stdout, r'\Asubmit: .*: job \d+ is at it; .*\n\Z')
        self.assert_collected()
        self.assertIn('restitution', self.log('collect.log'))
        self.assertNotIn('shards', self.submit())  # all are there: only collected again
        self.assert_collected()
        done = self.try_to_submit('--tasks', '3')
        self.assertEqual(done.returncode, 2)
        self.assertIn(f'has shards of {TASKS}', done.stdout)

    def test_dead_node_loses_nothing(self):
        self.submit()
        sweep, _ = self.stopped_sweep()
        self.slurm.kill_node(sweep.node)
        self.slurm.kill_jobs(sweep.node)
        self.slurm.wait_for(lambda: 'down' in ''.join(self.slurm.states_of_nodes()), 'a dead node')
        self.assert_collected()
        self.assertGreaterEqual(self.restarts(), 1)

    def test_node_that_comes_back_loses_nothing(self):
        self.submit()
        sweep, shard = self.stopped_sweep()
        self.slurm.kill_node(sweep.node)
        os.kill(sweep.pid, signal.SIGCONT)
        self.slurm.start_node(sweep.node)
        self.assert_collected()

    def test_task_waits_for_one_left_behind(self):
        """On a node that Slurm gives up, but which computes on."""
        self.submit()
        sweep, shard = self.stopped_sweep()
        self.slurm.kill_node(sweep.node)
        name = str(self.output / f'shard-{shard}-of-{TASKS}.csv')
        self.slurm.wait_for(lambda: any(one.words[0] == 'flock' and name in one.words
                                        for one in self.slurm.processes()), 'a task that waits')
        os.kill(sweep.pid, signal.SIGCONT)
        self.assert_collected()
        self.assertGreaterEqual(self.restarts(), 1)

    def test_cancelled_task_is_named_and_made_up_for(self):
        self.submit()
        sweep, shard = self.stopped_sweep()
        self.slurm.tell('scancel', '--signal=KILL', '--name=a_sweep', '--state=RUNNING',
                        f'--nodelist={sweep.node}')
        self.slurm.wait_for_end()
        self.assertFalse((self.output / 'sweep.csv').exists())
        self.assertRegex(self.log('collect.log'), rf'runs are missing: shard .*{shard}/{TASKS} has ')
        self.assertIn(f': 1 of {TASKS} shards', self.submit())
        self.assert_collected()

    def preempt(self):
        self.submit()
        self.stopped_sweep()
        self.slurm.tell('sbatch', '--partition=high', '--nodes=2', '--wrap=sleep 1',
                        '--output=/dev/null')
        self.assert_collected()
        self.assertGreaterEqual(self.restarts(), 1)

    def test_preempted_tasks_go_on(self):
        self.preempt()


class WithGrace(OnSlurm):
    options = {'grace': 2}
    test_preempted_tasks_go_on = Submit.preempt


class FewTasks(OnSlurm):
    options = {'max_array_size': 4}

    def test_shards_are_as_many_as_slurm_takes(self):
        done = self.try_to_submit('--tasks', '4')
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stdout, r"got 4, allowed by this cluster's MaxArraySize: 3\n\Z")
        self.assertFalse(self.output.exists())
        self.submit('--tasks', '3')
        self.assert_collected()


if __name__ == '__main__':
    unittest.main()
