#!/usr/bin/python3
"""plot_impact draws the numbers that impact wrote, and films its states."""

import os
import signal
import subprocess
import time

import python_program
from python_program import SMALL_DAMPED, SMALL_WALL, InFolder, run, simulate

import matplotlib
matplotlib.use('Agg')
import numpy as np
from PIL import Image

from impact_py import course, film, history, style
from impact_py.recording import open_recording


class Course(InFolder):
    def test_lines_are_the_history(self):
        recording = open_recording(simulate(self.folder / 'run', SMALL_DAMPED))
        course_of_run = recording.history()
        strain, energies, force, velocity, *_ = course.draw_course(course_of_run, '').axes
        table = np.genfromtxt(self.folder / 'run/history.csv', delimiter=',', skip_header=1)
        np.testing.assert_array_equal(strain.lines[0].get_xydata(), table[:, [0, 1]])
        np.testing.assert_array_equal(force.lines[0].get_xydata(), table[:, [0, 2]])
        np.testing.assert_array_equal(velocity.lines[-1].get_xydata(), table[:, [0, 4]])
        # The layers lie on each other: the uppermost edge is the sum of them.
        names = [layer.get_label().split(',')[0] for layer in energies.collections]
        self.assertEqual(names, ['translation', 'rotation', 'vibration', 'bonds', 'wall',
                                 'dissipated'])
        first = energies.collections[0].get_paths()[0].vertices
        self.assertAlmostEqual(first[:, 1].max(), table[0, 5], delta=1e-15)
        top = energies.collections[-1].get_paths()[0].vertices[:, 1].max()
        layers = table[:, [5, 6, 7, 8, 9, 11]]
        self.assertAlmostEqual(top, layers.sum(axis=1).max(), delta=1e-15)

    def test_energy_that_is_nowhere_is_not_drawn(self):
        shown = history.History(np.arange(3.0), None, None, None,
                                {name: np.zeros(3) for name in history.ENERGIES})
        shown.energies['bonds'] = np.array([1.0, 0.5, 0.0])
        shown.energies['load'] = np.array([7.0, 7.5, 8.0])
        self.assertEqual([(name, list(energy)) for name, energy in course.energy_layers(shown)],
                         [('bonds', [1, 0.5, 0]), ('load', [0, 0.5, 1])])

    def test_columns_agree_with_the_states(self):
        """The C++ ledger, and the same energies from the states by other formulas."""
        recording = open_recording(simulate(self.folder / 'run', [*SMALL_WALL, 'material.k_b=1000'],
                                            '--states'))
        written, measured = self.assert_energies_agree(
            recording, ('translation', 'rotation', 'vibration', 'bonds', 'wall lattice'))
        energy_of_impact = written.energies['translation'][0]
        np.testing.assert_allclose(measured.strain, written.strain, atol=1e-14)
        np.testing.assert_allclose(measured.velocity, written.velocity, atol=1e-16)
        # Points that the wall hardly pushes are not in the dump: 1e-6 of the velocity each.
        np.testing.assert_allclose(measured.force, written.force, atol=1e-5)
        np.testing.assert_allclose(measured.energies['wall'], written.energies['wall'],
                                   atol=1e-4 * energy_of_impact)
        self.assertGreater(written.energies['absorbed'][-1], 1e-3 * energy_of_impact)
        lost = written.energies['absorbed'] + written.energies['hops']
        np.testing.assert_allclose(measured.energies['absorbed'], lost,
                                   atol=2e-4 * energy_of_impact)  # the wall's and the step's error


    def assert_energies_agree(self, recording, names):
        written = recording.history()
        ledger = type('Ledger', (), {'total': sum(energy[0] for energy
                                                  in written.energies.values()),
                                     'dissipated': 0.0, 'absorbed': 0.0, 'hops': 0.0})
        measured = history.measure_history(recording, [(0, ledger)])
        for name in names:
            np.testing.assert_allclose(measured.energies[name], written.energies[name],
                                       atol=1e-12 * written.energies['translation'][0],
                                       err_msg=name)
        return written, measured

    def test_columns_of_two_disks_agree_with_the_states(self):
        recording = open_recording(simulate(
            self.folder / 'run', ['disk_on_disk', 'disk.points=30', 'wall.radius=1.3',
                                  'wall.k_a=0.5', 'impact.velocity=0.05', 'impact.angle=30'],
            '--states'))
        written, measured = self.assert_energies_agree(
            recording, ('translation', 'rotation', 'vibration', 'bonds'))
        self.assertNotIn('elastic wall', course.title_of(recording))
        self.assertGreater(written.energies['wall'].max(),
                           0.02 * written.energies['translation'][0])
        # A point's forces are added up before their size is taken: those of two bonds that meet at
        # an angle of 0.3 lose 1 % of it.
        np.testing.assert_allclose(measured.energies['wall'], written.energies['wall'],
                                   atol=0.02 * written.energies['wall'].max())

    def test_columns_of_a_row_of_disks_agree_with_the_states(self):
        recording = open_recording(simulate(
            self.folder / 'run', ['row_of_disks', 'disk.points=30', 'wall.radius=1', 'wall.a=500',
                                  'impact.velocity=0.05', 'impact.angle=10'], '--states'))
        self.assertEqual([len(body.points) for body in recording.bodies], 4 * [30])
        self.assertIn('4 disks', course.title_of(recording))
        written, measured = self.assert_energies_agree(
            recording, ('translation', 'rotation', 'vibration', 'bonds'))
        np.testing.assert_allclose(measured.energies['wall'], written.energies['wall'],
                                   atol=0.02 * written.energies['wall'].max())

    def test_weight_is_in_the_load(self):
        recording = open_recording(simulate(
            self.folder / 'run', [*SMALL_DAMPED, 'material.eta=0', 'gravity=2e-3'], '--states'))
        self.assert_energies_agree(recording, ('translation', 'bonds', 'load'))


class Film(InFolder):
    def test_colours_and_arrows_are_those_of_the_state(self):
        recording = open_recording(simulate(self.folder / 'run', SMALL_WALL, '--states'))
        style.choose_window(False)
        states = film.chosen_states(recording, 5)
        times = recording.times()
        self.assertEqual([states[0].time, states[-1].time], [times[0], times[-1]])
        self.assertEqual(len(states), 5)
        state = max(recording.states(), key=lambda state: state.force[:, 1].max())
        moving = film.Film(recording, [*states, state])
        moving.show(5, state)
        lines = moving.drawing.lines
        ends = np.array(lines.get_segments())
        np.testing.assert_array_equal(ends, state.position[recording.bonds()])
        lengths = np.hypot(*(ends[:, 1] - ends[:, 0]).T)
        natural = np.concatenate([body.natural_lengths for body in recording.bodies])
        np.testing.assert_allclose(lines.get_array(), 100 * (lengths / natural - 1), atol=1e-12)
        self.assertEqual(lines.get_clim()[0], -lines.get_clim()[1])
        pushed = state.force[:30][np.hypot(*state.force[:30].T) > 0]
        longest = np.max(np.hypot(moving.drawing.arrows.U, moving.drawing.arrows.V))
        self.assertAlmostEqual(longest, 0.3)
        self.assertLessEqual(len(moving.drawing.arrows.U), len(pushed))

    def test_films_are_written(self):
        simulate(self.folder / 'run', [*SMALL_DAMPED, 'output.period=8'], '--states')
        done = run('plot_impact', self.folder / 'run', '--animate', self.folder / 'f.gif')
        self.assertEqual((done.returncode, done.stdout), (0, f'{self.folder}/f.gif\n'))
        with Image.open(self.folder / 'f.gif') as picture:
            self.assertEqual(picture.n_frames,
                             len(open_recording(self.folder / 'run').history().time))
        self.assertEqual(sorted(os.listdir(self.folder)), ['f.gif', 'run'])


class Output(InFolder):
    """What impact writes for the plots."""

    def test_interrupted_run_leaves_nothing(self):
        folder = self.folder / 'run'
        scene = python_program.ROOT / 'launch/scenes/collision.yaml'
        with subprocess.Popen([python_program.IMPACT, str(scene), 'impact.velocity=1e-4',
                               'disk.points=300', '--output', str(folder), '--states'],
                              stderr=subprocess.PIPE, universal_newlines=True) as impact:
            while not (folder / 'states.lammpstrj.part').exists():
                self.assertIsNone(impact.poll())
                time.sleep(0.01)
            impact.send_signal(signal.SIGINT)
            _, message = impact.communicate()
        self.assertEqual((impact.returncode, message), (1, 'impact: interrupted\n'))
        self.assertEqual(os.listdir(self.folder), [])

    def test_states_need_a_folder(self):
        done = subprocess.run([python_program.IMPACT,
                               str(python_program.ROOT / 'launch/scenes/collision.yaml'),
                               '--states'], stderr=subprocess.PIPE, universal_newlines=True,
                              check=False)
        self.assertEqual((done.returncode, done.stderr), (2, 'impact: --states needs --output\n'))

    def test_states_of_an_earlier_run_go(self):
        folder = simulate(self.folder / 'run', SMALL_DAMPED, '--states')
        self.assertIn('states.lammpstrj', os.listdir(folder))
        simulate(folder, SMALL_DAMPED)
        self.assertEqual(sorted(os.listdir(folder)),
                         ['history.csv', 'lattice.data', 'result.yaml', 'scene.yaml'])


class Program(InFolder):
    def test_picture_goes_beside_the_input_or_where_it_is_told(self):
        folder = simulate(self.folder / 'run', SMALL_DAMPED)
        environment = {key: value for key, value in os.environ.items() if key != 'DISPLAY'}
        done = run('plot_impact', folder, env=environment)
        self.assertEqual((done.returncode, done.stdout), (0, f'{folder}/impact.png\n'))
        for name in ('a.svg', 'a.pdf'):
            done = run('plot_impact', folder, '--output', self.folder / name)
            self.assertEqual(done.returncode, 0)
        self.assertEqual(sorted(os.listdir(self.folder)), ['a.pdf', 'a.svg', 'run'])

    def test_bad_input_is_refused(self):
        folder = simulate(self.folder / 'run', SMALL_DAMPED)
        self.assert_refused(run('plot_impact', self.folder / 'none'), 'no such folder or bag')
        self.assert_refused(run('plot_impact', self.folder), 'folder of impact --output')
        self.assert_refused(run('plot_impact', folder, '--output', 'a.jpg'), 'ends in .svg')
        self.assert_refused(run('plot_impact', folder, '--output', '/none/a.svg'), 'no folder')
        self.assert_refused(run('plot_impact', folder, '--animate', 'a.avi'), 'ends in .mp4')
        self.assert_refused(run('plot_impact', folder, '--animate', 'a.gif'), '--states')
        self.assert_refused(run('plot_impact', folder, '--animate', 'a.mp4', env={'PATH': '/none'}),
                            'ffmpeg is missing')
        self.assert_refused(run('plot_impact', folder, '--run', 3), '--run 0')
        self.assert_refused(run('plot_impact', python_program.__file__), 'bag')
        self.assertEqual(os.listdir(self.folder), ['run'])


if __name__ == '__main__':
    python_program.main()
