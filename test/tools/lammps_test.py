#!/usr/bin/python3
"""to_lammps writes an impact that LAMMPS moves as impact does, and from_lammps reads the result."""

import os
import shutil
import subprocess
import unittest
from pathlib import Path

import python_program
from python_program import ROOT, InFolder

import numpy as np
import yaml

SCENE = ROOT / 'launch/scenes/collision.yaml'
STEP = 0.004  # R/c
# Sliding, spinning and fast, so that all that is written counts.
GIVEN = [f'numerics.step={STEP}', 'impact.velocity=0.05', 'impact.angle=20', 'impact.spin=0.02',
         'material.k_b=20']


def program(name, *arguments):
    """One of the programs beside impact; stdout and stderr in one text."""
    command = [str(Path(python_program.IMPACT).with_name(name)), *map(str, arguments)]
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          universal_newlines=True, check=False)


def result_of(name, *arguments):
    done = program(name, *arguments)
    assert done.returncode == 0, done.stdout
    return yaml.safe_load(done.stdout)


class Written(InFolder):
    def to_lammps(self, *arguments):
        return program('to_lammps', SCENE, self.folder / 'run', *arguments)

    def test_says_what_to_do_next(self):
        done = self.to_lammps('disk.points=50')
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertRegex(done.stdout, r'\A50 points, \d+ bonds, steps of \S+ R/c\ncd \S+/run && mpirun')
        self.assertEqual(sorted(os.listdir(self.folder / 'run')),
                         ['bonds.in', 'in.lammps', 'scene.yaml', 'start.data'])

    def test_nothing_stays_of_what_is_refused(self):
        self.assert_refused(self.to_lammps('material.eta=1'), 'material.eta: got 1, allowed: 0')
        self.assert_refused(self.to_lammps('seed=[1, 2]'), 'seed: got .*, allowed: one value')
        self.assert_refused(self.to_lammps('numerics.step=1'), 'numerics.step: got 1, allowed')
        self.assertEqual(os.listdir(self.folder), [])

    def test_writes_anew_but_not_over_a_run(self):
        self.to_lammps('disk.points=50')
        self.assertEqual(self.to_lammps('disk.points=60').returncode, 0)
        self.assertIn('60 atoms', (self.folder / 'run/start.data').read_text())
        (self.folder / 'run/force.txt').write_text('0 0\n')
        self.assert_refused(self.to_lammps('disk.points=70'), r'LAMMPS has run here \(force.txt\)')
        self.assertIn('60 atoms', (self.folder / 'run/start.data').read_text())

    def test_no_result_without_a_run(self):
        self.assert_refused(program('from_lammps', self.folder), 'scene.yaml: ')
        self.to_lammps('disk.points=50')
        self.assert_refused(program('from_lammps', self.folder / 'run'), 'force.txt: cannot be read')


@unittest.skipIf(shutil.which('lmp') is None, 'needs lammps')
class Lammps(InFolder):
    def setUp(self):
        super().setUp()
        self.run_folder = self.folder / 'run'
        done = program('to_lammps', SCENE, self.run_folder, *GIVEN)
        self.assertEqual(done.returncode, 0, done.stdout)

    def lammps(self, *before, script='in.lammps'):
        done = subprocess.run([*before, 'lmp', '-in', script], cwd=self.run_folder,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              universal_newlines=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertNotIn('WARNING', done.stdout)
        return result_of('from_lammps', self.run_folder)

    def assert_near(self, one, other, tolerance):
        for key in ('restitution', 'contact_duration', 'peak_force', 'impulse', 'spin_after',
                    'tangential_restitution', 'energy_restitution', 'normal_energy'):
            self.assertAlmostEqual(one[key] / other[key], 1.0, delta=tolerance, msg=key)

    def test_impact_is_that_of_impact(self):
        """They end at different times, when the wall holds 10⁻⁸ of the energy at most."""
        theirs = self.lammps()
        ours = result_of('impact', self.run_folder / 'scene.yaml')
        self.assert_near(theirs, ours, 1e-8)
        self.assertEqual((theirs['step'], theirs['integrator']), (STEP, 'verlet'))
        self.assertEqual(theirs['flags'], [])
        self.assertLess(theirs['energy_error'], 1e-4)

    def test_two_processes_are_as_one(self):
        """But for rounding: sums of 1000 numbers, over 2000 steps."""
        alone = self.lammps()
        together = self.lammps('mpirun', '--oversubscribe', '-np', '2')
        self.assertIn('2 procs', (self.run_folder / 'log.lammps').read_text())
        self.assert_near(together, alone, 1e-11)

    def test_points_are_where_ours_are(self):
        """After 1000 steps, while the disk is on the wall."""
        script = (self.run_folder / 'in.lammps').read_text()
        before, _, _ = script.rpartition('fix end')
        (self.run_folder / 'in.1000').write_text(
            before + 'run 1000\nwrite_dump all custom end.dump x y modify sort id format float %.17g\n')
        self.lammps(script='in.1000')
        theirs = np.loadtxt(self.run_folder / 'end.dump', skiprows=9)
        python_program.simulate(self.folder / 'ours', ['collision', *GIVEN, f'output.period={5 * STEP}'],
                                '--states')
        states = (self.folder / 'ours/states.lammpstrj').read_text().split('ITEM: TIME\n')
        rows, = (state.splitlines()[10:] for state in states[1:]
                 if state.splitlines()[2] == '1000')
        ours = np.array([row.split()[2:4] for row in rows], dtype=float)
        self.assertEqual(ours.shape, theirs.shape)
        np.testing.assert_allclose(theirs, ours, rtol=0, atol=1e-9)


if __name__ == '__main__':
    python_program.main()
