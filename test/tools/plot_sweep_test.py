#!/usr/bin/python3
"""plot_sweep draws means over the seeds, one curve for each combination of the other swept keys."""

import unittest

from python_program import InFolder, run

import matplotlib
matplotlib.use('Agg')
import numpy as np

from impact_py import plot_sweep
from impact_py.tables import read_table

HEADER = 'scene,seed,material.eta,wall.type,impact.velocity,restitution,restitution_error,flags'
ROWS = [f'collision,{seed},{eta},potential,{v},{1 - v * (1 + eta) - 0.001 * seed},1e-6,'
        for seed in (1, 2, 3) for eta in (0, 10) for v in (0.01, 0.02)]


class PlotSweep(InFolder):
    def table(self, rows, header=HEADER):
        path = self.folder / 'sweep.csv'
        path.write_text('\n'.join([header, *rows]) + '\n')
        return read_table(path)

    def test_mean_and_error_over_seeds_are_drawn(self):
        table = self.table(ROWS)
        x, columns = plot_sweep.chosen_columns(table, None, [])
        self.assertEqual((x, columns), ('impact.velocity', ['restitution']))
        ax, = plot_sweep.draw_sweep(table, x, columns).axes
        self.assertEqual([text.get_text() for text in ax.get_legend().get_texts()],
                         [r'$\eta^*$ = 0', r'$\eta^*$ = 10'])
        for container, eta in zip(ax.containers, (0, 10)):
            line, _, (bars,) = container
            np.testing.assert_array_equal(line.get_xdata(), [0.01, 0.02])
            np.testing.assert_allclose(line.get_ydata(), [1 - v * (1 + eta) - 0.002
                                                          for v in (0.01, 0.02)])
            for (_, low), (_, high) in bars.get_segments():
                self.assertAlmostEqual(high - low, 2 * 0.001 / 3**0.5)

    def test_one_seed_has_the_error_of_its_row(self):
        (_, places, means, errors, counts), = plot_sweep.curves(
            self.table([row for row in ROWS if row.startswith('collision,1,0')]),
            'impact.velocity', 'restitution')
        np.testing.assert_array_equal(places, [0.01, 0.02])
        np.testing.assert_array_equal(errors, [1e-6, 1e-6])
        np.testing.assert_array_equal(counts, [1, 1])

    def test_columns_are_found_by_their_last_part(self):
        table = self.table(ROWS)
        self.assertEqual(plot_sweep.chosen_columns(table, 'eta', ['restitution_error']),
                         ('material.eta', ['restitution_error']))

    def test_several_columns_are_drawn_together(self):
        table = self.table([row for row in ROWS if ',0,potential' in row])
        x, columns = plot_sweep.chosen_columns(table, 'velocity',
                                               ['restitution', 'restitution_error'])
        ax, = plot_sweep.draw_sweep(table, x, columns).axes
        self.assertEqual([text.get_text() for text in ax.get_legend().get_texts()],
                         ['$e$', 'restitution_error'])
        self.assertEqual(ax.get_ylabel(), '')
        np.testing.assert_allclose(ax.containers[1][0].get_ydata(), [1e-6, 1e-6])

    def test_failed_rows_are_left_out_and_told(self):
        self.table([*ROWS, 'collision,4,0,potential,0.01,nan,nan,',
                    'collision,5,0,potential,0.01,,,"failed: it, and \\"so\\""'])
        done = run('plot_sweep', self.folder / 'sweep.csv', '--output', self.folder / 'a.svg')
        self.assertEqual(done.returncode, 0)
        self.assertIn('left out without a number: 2 of 14 rows', done.stdout)
        self.assertTrue((self.folder / 'a.svg').exists())

    def test_bad_input_is_refused(self):
        path = self.folder / 'sweep.csv'
        self.assert_refused(run('plot_sweep', path), 'No such file')
        self.table([])
        self.assert_refused(run('plot_sweep', path), 'has no rows')
        self.table(ROWS)
        self.assert_refused(run('plot_sweep', path, 'speed'), 'has no speed, only seed')
        self.assert_refused(run('plot_sweep', path, 'wall.type'), 'no column of numbers')
        self.assert_refused(run('plot_sweep', path, '--output', 'a.txt'), 'ends in .svg')
        path.write_text(HEADER + '\ncollision,1\n')
        self.assert_refused(run('plot_sweep', path), 'sweep.csv:2: has not the 8 cells')
        self.table(['collision,1,0,potential,0.01,nan,nan,failed'])
        self.assert_refused(run('plot_sweep', path, 'eta'), 'no row has a number')


if __name__ == '__main__':
    unittest.main()
