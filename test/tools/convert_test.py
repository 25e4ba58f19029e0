#!/usr/bin/python3
"""convert writes the numbers of the states, as other programs read them."""

import importlib.util
import os
import shutil
import subprocess
import unittest

import python_program
from python_program import SMALL_WALL, InFolder, run, simulate

import numpy as np

from impact_py.recording import open_recording

POINTS = 70  # 30 of the disk, 40 of the wall


def lacks(module):
    return importlib.util.find_spec(module) is None


class Converted(InFolder):
    def setUp(self):
        super().setUp()
        self.run_folder = simulate(self.folder / 'run', SMALL_WALL, '--states')
        self.recording = open_recording(self.run_folder)
        self.states = list(self.recording.states())

    def convert(self, form, name):
        path = self.folder / name
        done = run('convert', self.run_folder, form, '--output', path)
        self.assertEqual((done.returncode, done.stdout), (0, f'{path}\n'))
        return path


class Plain(Converted):
    def test_npz(self):
        arrays = np.load(self.convert('npz', 'a.npz'))
        for name in ('step', 'time', 'position', 'velocity', 'force'):
            np.testing.assert_array_equal(arrays[name], [getattr(s, name) for s in self.states])
        self.assertEqual(np.bincount(arrays['body']).tolist(), [0, 30, 40])
        ends = arrays['reference'][arrays['bonds']]
        np.testing.assert_array_equal(np.hypot(*(ends[:, 1] - ends[:, 0]).T),
                                      arrays['natural_length'])

    def test_dump_is_that_of_impact(self):
        """Two writers, one file; numbers such as 0 and 0.0 are written differently."""
        def words(path):
            return [[float(word) if word[-1].isdigit() else word for word in line.split()]
                    for line in path.read_text().splitlines()]
        dump = self.convert('lammps', 'a.lammpstrj')
        self.assertEqual(words(dump), words(self.run_folder / 'states.lammpstrj'))

    def test_xyz(self):
        lines = self.convert('xyz', 'a.xyz').read_text().splitlines()
        self.assertEqual(len(lines), len(self.states) * (POINTS + 2))
        for number, state in enumerate(self.states):
            count, comment, *rows = lines[number * (POINTS + 2):(number + 1) * (POINTS + 2)]
            self.assertEqual(int(count), POINTS)
            self.assertIn(f' Time={state.time!r} ', comment)
            self.assertEqual([row.split()[:3] for row in rows],
                             [[str(point + 1), '1' if point < 30 else '2', 'X']
                              for point in range(POINTS)])
            cells = np.array([row.split()[3:] for row in rows], dtype=float)
            np.testing.assert_array_equal(cells[:, [0, 1]], state.position)
            np.testing.assert_array_equal(cells[:, [3, 4]], state.velocity)
            np.testing.assert_array_equal(cells[:, [6, 7]], state.force)

    def test_nothing_half_written_stays(self):
        with open(self.run_folder / 'states.lammpstrj', 'r+') as file:
            file.truncate(2 * os.stat(file.fileno()).st_size // 3)
        for form, name in (('lammps', 'a.lammpstrj'), ('xyz', 'a.xyz'), ('npz', 'a.npz')):
            done = run('convert', self.run_folder, form, '--output', self.folder / name)
            self.assert_refused(done, 'no dump of this run')
        self.assertEqual(os.listdir(self.folder), ['run'])

    def test_bad_input_is_refused(self):
        self.assert_refused(run('convert', self.run_folder, 'mcap'), 'mcap')
        self.assert_refused(run('convert', self.run_folder, 'xyz', '--output', 'a.txt'), '.xyz')

    def test_missing_library_is_named(self):
        hidden = self.folder / 'hidden'
        hidden.mkdir()
        (hidden / 'meshio.py').write_text('raise ModuleNotFoundError("none", name="meshio")\n')
        done = run('convert', self.run_folder, 'vtk', '--output', self.folder / 'a.pvd',
                   env={**os.environ, 'PYTHONPATH': str(hidden)})
        self.assert_refused(done, 'install python3-meshio', 1)
        self.assertEqual(sorted(os.listdir(self.folder)), ['hidden', 'run'])


@unittest.skipIf(lacks('meshio') or lacks('vtk'), 'needs python3-meshio and python3-vtk9')
class Vtk(Converted):
    def test_vtk_reads_the_same_numbers(self):
        from vtk.util.numpy_support import vtk_to_numpy
        from vtk.vtkIOXML import vtkXMLUnstructuredGridReader
        from xml.etree import ElementTree

        index = ElementTree.parse(self.convert('vtk', 'a.pvd'))
        entries = list(index.getroot().find('Collection'))
        self.assertEqual([float(entry.get('timestep')) for entry in entries],
                         [state.time for state in self.states])
        for entry, state in zip(entries, self.states):
            reader = vtkXMLUnstructuredGridReader()
            reader.SetFileName(str(self.folder / entry.get('file')))
            reader.Update()
            grid = reader.GetOutput()
            np.testing.assert_array_equal(vtk_to_numpy(grid.GetPoints().GetData())[:, :2],
                                          state.position)
            for name in ('velocity', 'force'):
                data = vtk_to_numpy(grid.GetPointData().GetArray(name))
                np.testing.assert_array_equal(data[:, :2], getattr(state, name))
            np.testing.assert_array_equal(vtk_to_numpy(grid.GetCellData().GetArray('strain')),
                                          self.recording.strains(state))
            bonds = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 2)
            np.testing.assert_array_equal(bonds, self.recording.bonds())

    def test_folder_in_the_way_is_not_touched(self):
        (self.folder / 'a_vtu').mkdir()
        done = run('convert', self.run_folder, 'vtk', '--output', self.folder / 'a.pvd')
        self.assert_refused(done, 'a_vtu: is there already')


@unittest.skipIf(shutil.which('lmp') is None, 'needs lammps')
class Lammps(Converted):
    INPUT = '''
units lj
dimension 2
boundary s s p
atom_style bond
comm_modify cutoff 3
pair_style none
bond_style zero
read_data a.data
bond_coeff * 1
compute length all bond/local dist
compute bonds all reduce sum c_length
dump out all custom 1 out.dump id x y vx vy
dump_modify out sort id format float %.17g
thermo 1
thermo_style custom step c_bonds
thermo_modify norm no format float %.17g
rerun a.lammpstrj dump x y vx vy
'''

    def test_rerun_reads_the_same_numbers(self):
        self.convert('lammps', 'a.lammpstrj')
        (self.folder / 'in').write_text(self.INPUT)
        done = subprocess.run(['lmp', '-in', 'in', '-log', 'none'], cwd=self.folder,
                              stdout=subprocess.PIPE, universal_newlines=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout)
        text = (self.folder / 'out.dump').read_text()
        frames = [frame.splitlines() for frame in text.split('ITEM: TIMESTEP\n')[1:]]
        self.assertEqual([int(frame[0]) for frame in frames], [s.step for s in self.states])
        for frame, state in zip(frames, self.states):
            cells = np.array([row.split() for row in frame[8:]], dtype=float)
            # It adds 0 lengths of its box, which may round once.
            np.testing.assert_allclose(cells[:, [1, 2]], state.position, atol=1e-15)
            np.testing.assert_array_equal(cells[:, [3, 4]], state.velocity)
        sums = [line.split()[1] for line in done.stdout.splitlines()
                if line.split()[:1] == [str(self.states[-1].step)]]
        lengths = [body.lengths(part) for body, part in
                   zip(self.recording.bodies, self.recording.parts(self.states[-1].position))]
        self.assertAlmostEqual(float(sums[0]), np.concatenate(lengths).sum(), places=11)


if __name__ == '__main__':
    python_program.main()
