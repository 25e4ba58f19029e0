#!/usr/bin/python3
"""plot_figures makes every figure, also from gaps in the data, and refuses what is not there."""

import argparse
import unittest
import warnings

from python_program import InFolder, run

import matplotlib
matplotlib.use('Agg')
import matplotlib.pyplot as plt
import numpy as np

from impact_py import plot_figures, style
from impact_py.figures import lattices, precision, restitution
from impact_py.tables import read_table

SPEEDS = (0.003, 0.01, 0.05)


def write(folder, name, lines):
    (folder / name).write_text('\n'.join(lines) + '\n')


def write_drawing(folder, name):
    write(folder, name + '_points.csv', ['x,y,fx,fy', '0,0,0,0.1', '1,0,0,0.2', '0,1,0,0'])
    write(folder, name + '_bonds.csv',
          ['first,second,strain', '0,1,-0.01', '1,2,0.02', '2,0,0'])


def write_figure2(folder):
    write(folder, 'figure2.csv',
          ['P_by_pi_E_R,strain,strain_error,fit,hertz,inertial_load,paper_fit',
           '0.001,0.006,0.0001,0.006,0.007,0.007,0.012',
           '0.002,nan,nan,nan,0.014,0.014,0.024'])
    write(folder, 'figure2_fits.csv',
          ['case,b,b_sampling_error,theory,paper', 'default,nan,nan,0.92,1.55'])
    write(folder, 'figure2_pressure.csv',
          ['x_by_half_width,hertz,N_1099,N_16000,N_16000_a_3000',
           '-0.5,0.55,0.5,0.5,nan', '0.5,0.55,0.6,0.5,nan'])


def write_figure3(folder):
    lines = ['wall_a,eta,velocity,velocity_by_sound_speed,restitution,restitution_error,fit,'
             'contact_duration,contact_duration_theory,dissipation_time_by_eta_by_k_a,ode']
    for wall, eta in ((300, 0), (300, 1), (300, 10), (3000, 0), (3000, 1)):
        lines += [f'{wall},{eta},{v},{v / 1.8},{1 - v},0.01,nan,5,4,-nan,1' for v in SPEEDS]
    write(folder, 'figure3.csv', lines)
    write(folder, 'figure3_losses.csv', ['wall_a,eta,velocity,loss,spin,damping,vibration'] +
          [f'{wall},{eta},{v},0.04,0.01,0.01,0.02'
           for wall, eta in ((300, 0), (300, 1), (3000, 0)) for v in SPEEDS])


def write_figure6(folder):
    lines = ['case,velocity,velocity_by_sound_speed,restitution,restitution_error,fit,paper_fit']
    lines += [f'reset 0.004,{v},{v / 1.8},{1 - v},nan,nan,0.95' for v in SPEEDS]
    write(folder, 'figure6.csv', lines)
    write(folder, 'figure6_fits.csv', ['case,d1,d2', 'reset 0.004,nan,nan'])


def write_precision(folder):
    """The contact's curves are verified answers, the others' are runs; one error is 0."""
    header = ('kind,integrator,wanted_error,time,force_evaluations,error,position_error,'
              'on_front')
    write(folder, 'work_precision_contact.csv',
          [header, 'verified,newton,0.01,0.001,5,0,0,1', 'verified,bdf,0.01,0.1,50,1e-3,1e-5,0',
           'verified,auto,0.01,0.001,5,0,0,0'])
    for name in ('collision_eta0', 'collision_eta1', 'collision_eta100', 'absorbing_wall'):
        write(folder, f'work_precision_{name}.csv',
              [header, 'run,verlet,nan,0.1,500,1e-3,1e-4,1', 'run,rk8pd,nan,1,5000,1e-9,1e-10,1',
               'bare,verlet,0.01,0.1,500,1e-3,nan,0', 'verified,auto,0.01,0.2,nan,1e-3,nan,0'])
    write(folder, 'references.csv',
          ['scene,uncertainty,position_uncertainty'] +
          [f'{name},1e-12,1e-13' for name in ('contact', 'collision_eta0', 'collision_eta1',
                                               'collision_eta100', 'absorbing_wall')])
    lines = ['eta_of_1099_points,points,scatter,difference,difference_error,time']
    for eta in (0, 100):
        lines += [f'{eta},100,0.01,0.02,0.001,0.001', f'{eta},1000,nan,nan,nan,0.1']
    write(folder, 'discretisation.csv', lines)


def write_oblique(folder):
    """On one wall everything at one angle was refused; on another some of it."""
    numbers = ('restitution', 'straight', 'gain', 'slope', 'chord', 'on_slope', 'on_chord')
    walls = ((1, 0.1), (0.01, 0.1))
    write(folder, 'oblique.csv',
          ['wall_k_a,velocity,tan_gamma,refused,' +
           ','.join(f'{name},{name}_error' for name in numbers)] +
          [f'{k_a},{v},0,1' + ',0.9,nan' * len(numbers) for k_a, v in walls] +
          [f'{walls[0][0]},0.1,5,0' + ',0.8,0.01' * len(numbers),
           f'{walls[1][0]},0.1,5,2' + ',nan,nan' * len(numbers)])
    write(folder, 'oblique_impacts.csv',
          ['wall_k_a,velocity,gain,straight,on_slope', '1,0.1,0.01,0.9,0.92',
           '0.01,0.1,-0.05,0.9,1.2'])


def write_accuracy(folder):
    """Of one kind there is none; an answer without an error, one in doubt, one refused."""
    write(folder, 'accuracy.csv',
          ['kind,numerics.error,true_error,true_over_estimated,verdict',
           'contact,1e-4,1e-5,0.3,kept', 'contact,1e-4,0,0,kept',
           'potential wall,1e-4,1e-3,nan,undefined', 'potential wall,1e-4,nan,nan,refused'])


def plot(figure, folder):
    """Without the seconds that a fine picture and the start of a program take."""
    with warnings.catch_warnings():
        warnings.simplefilter('error')
        plot_figures.perform(argparse.Namespace(figure=figure, folder=folder))


class PlotFiguresTest(InFolder):
    @classmethod
    def setUpClass(cls):
        style.STYLE['savefig.dpi'] = 40
        style.KINDS = ('.png',)

    def pictures(self):
        return {file.name: file.read_bytes() for file in self.folder.glob('*.[ps][nv]g')}

    def test_all_figures_are_made_of_data_with_gaps(self):
        for write_one in (write_figure2, write_figure3, write_figure6):
            write_one(self.folder)
        for name in ('figure1', 'figure4'):
            write_drawing(self.folder, name)
        plot('all', self.folder)
        names = ['figure1', 'figure2', 'figure3', 'figure3_dissipation', 'figure3_duration',
                 'figure3_losses', 'figure4', 'figure6']
        self.assertEqual(sorted(self.pictures()),
                         sorted(name + '.png' for name in names))

    def test_work_precision_is_made_of_data_with_gaps(self):
        write_precision(self.folder)
        plot('work_precision', self.folder)
        names = ['discretisation'] + [file.stem for file in self.folder.glob('work_*.csv')]
        self.assertEqual(set(self.pictures()),
                         {name + '.png' for name in names})

    def test_oblique_is_made_of_data_with_gaps(self):
        write_oblique(self.folder)
        plot('oblique', self.folder)
        self.assertEqual(set(self.pictures()), {'oblique.png'})

    def test_accuracy_is_made_of_data_with_gaps(self):
        write_accuracy(self.folder)
        plot('accuracy', self.folder)
        self.assertEqual(set(self.pictures()), {'accuracy.png'})

    def test_one_figure_needs_only_its_own_data_and_is_the_same_again(self):
        write_figure2(self.folder)
        self.assertEqual(run('plot_figures', 'figure2', self.folder).returncode, 0)
        before = self.pictures()
        self.assertEqual(set(before), {'figure2.png', 'figure2.svg'})
        self.assertEqual(run('plot_figures', 'figure2', self.folder).returncode, 0)
        self.assertEqual(self.pictures(), before)

    def test_missing_file_and_column_are_refused_in_one_line(self):
        write_figure2(self.folder)
        (self.folder / 'figure2_fits.csv').unlink()
        done = run('plot_figures', 'figure2', self.folder)
        self.assert_refused(done, r'figure2_fits\.csv: No such file')
        write(self.folder, 'figure2_fits.csv', ['case,theory', 'default,0.92'])
        done = run('plot_figures', 'figure2', self.folder)
        self.assert_refused(done, r'figure2_fits\.csv: has no b')

    def test_lattice_is_drawn_by_strain_and_force(self):
        write_drawing(self.folder, 'figure1')
        figure, axes = lattices.draw_contact(self.folder, 'figure1', 3, ((0, 1), (0, 1)))
        lines, arrows = axes[0].collections[:2]
        np.testing.assert_array_equal(lines.get_array(), [-1, 2, 0])
        np.testing.assert_array_equal(np.array(lines.get_segments())[1], [[1, 0], [0, 1]])
        np.testing.assert_array_equal(arrows.get_offsets(), [[0, 0], [1, 0]])
        np.testing.assert_allclose(arrows.V, [0.11, 0.22])
        plt.close(figure)

    def test_what_was_not_simulated_is_said(self):
        write_figure3(self.folder)
        table = read_table(self.folder / 'figure3.csv')
        styles = restitution.damping_styles(table)
        ax = plt.figure().add_subplot()
        restitution.say_what_is_missing(ax, table.where('wall_a', 300), styles)
        self.assertEqual(len(ax.texts), 0)
        restitution.say_what_is_missing(ax, table.where('wall_a', 3000), styles)
        self.assertEqual(ax.texts[0].get_text(), r'$\eta^* =$ 10: not simulated')

    def test_losses_are_stacked_in_shares(self):
        write_figure3(self.folder)
        figure, axes = restitution.draw_losses(read_table(self.folder / 'figure3_losses.csv'))
        self.assertEqual(len(axes), 2)
        # Of a loss of 0.04: spin 0.01, vibration 0.02, damping 0.01.
        tops = [area.get_paths()[0].vertices[:, 1].max() for area in axes[0].collections]
        np.testing.assert_allclose(tops, [0.25, 0.75, 1.0])
        plt.close(figure)

    def test_equal_answers_are_one_star(self):
        groups = precision.groups_of_answers(np.array([1.0, 1.2, 1.1, 5.0]),
                                             np.array([1e-6, 1e-6, 1e-9, 1e-6]))
        self.assertEqual(groups, [[0, 1], [2], [3]])


if __name__ == '__main__':
    unittest.main()
