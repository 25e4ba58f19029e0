"""What the programs and nodes show at the keyboard: results, help, versions, suggestions, names."""

import json
import os
import pathlib
import pty
import re
import subprocess
import sys
import tempfile
import unittest
from xml.etree import ElementTree

import yaml

SOURCE = pathlib.Path(__file__).resolve().parents[2]
PROGRAMS = pathlib.Path(sys.argv.pop(1))
TOOLS = ('impact', 'sweep', 'units', 'reproduce', 'work_precision', 'stability', 'accuracy_check',
         'analyse_bag', 'to_lammps', 'from_lammps')
SCRIPTS = ('convert', 'plot_figures', 'plot_impact', 'plot_sweep', 'submit')
NODES = ('simulation_node', 'analysis_node', 'recorder_node', 'replay_node', 'viewer_node')
SMALL = ('collision', 'points=100', 'velocity=0.05')
DISK = 'radius=0.05,density=1100,young=5e6,thickness=0.01'
TIMEOUT = 60.0  # s, far above what anything here takes

# No node may look for a master.
ENVIRONMENT = {key: value for key, value in os.environ.items() if key != 'ROS_MASTER_URI'}


def run(name, *arguments):
    return subprocess.run([str(PROGRAMS / name), *arguments], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, universal_newlines=True, env=ENVIRONMENT,
                          timeout=TIMEOUT)


def on_a_terminal(*command):
    """What a program writes to stdout and stderr where both are a terminal."""
    try:
        ours, theirs = pty.openpty()
    except OSError as error:
        raise unittest.SkipTest('no terminal to be had: {}'.format(error)) from None
    process = subprocess.Popen([str(PROGRAMS / command[0]), *command[1:]], stdout=theirs,
                               stderr=theirs, env=ENVIRONMENT)
    os.close(theirs)
    text = b''
    try:
        while True:
            part = os.read(ours, 65536)
            if not part:
                break
            text += part
    except OSError:
        pass  # all ends of the terminal are closed
    os.close(ours)
    process.wait(TIMEOUT)
    return text.decode()


class KeyboardTest(unittest.TestCase):
    def output_of(self, name, *arguments):
        done = run(name, *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def assert_refused(self, line, name, *arguments):
        done = run(name, *arguments)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn(line, done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)

    def test_result_is_yaml_in_a_pipe_and_json_if_asked_for(self):
        by_yaml = yaml.safe_load(self.output_of('impact', *SMALL))
        by_json = json.loads(self.output_of('impact', *SMALL, '--json'))
        self.assertEqual(by_yaml.pop('wall_time') > 0, by_json.pop('wall_time') > 0)
        self.assertEqual(by_yaml, by_json)

    def test_what_is_not_known_is_null_in_json(self):
        result = json.loads(self.output_of('impact', *SMALL, 'step=0.01', '--json'))
        self.assertIsNone(result['restitution_error'])

    def test_result_is_text_on_a_terminal(self):
        text = on_a_terminal('impact', *SMALL)
        self.assertIn('collision at 0.05 c, 100 points, seed 1', text)
        self.assertRegex(text, r'restitution e +0\.\d+ +± [\d.e-]+')
        self.assertRegex(text, r'peak force .* M c²/R\b')
        self.assertIn('restitution: ', on_a_terminal('impact', *SMALL, '--yaml'))

    def test_progress_on_a_terminal_has_rate_and_time_left(self):
        text = on_a_terminal('impact', 'collision', 'points=10000', 'velocity=0.001',
                             'integrator=verlet')
        self.assertRegex(text, r'\r\[#*-*\] .* R/c: \d+ %, \d+ steps/s, \d+ s left')
        self.assertIn('to confirm the error', text)

    def test_formats_exclude_each_other(self):
        self.assert_refused('--yaml excludes --json', 'impact', *SMALL, '--yaml', '--json')

    def test_scenes_and_keys_by_name(self):
        scene = SOURCE / 'launch' / 'scenes' / 'collision.yaml'
        by_path = yaml.safe_load(self.output_of(
            'impact', str(scene), 'disk.points=100', 'impact.velocity=0.05'))
        by_name = yaml.safe_load(self.output_of('impact', *SMALL))
        self.assertEqual(by_path['restitution'], by_name['restitution'])
        self.assert_refused('colision: no such scene (did you mean collision?)', 'impact',
                            'colision')
        self.assert_refused('points: ambiguous, allowed: disk.points or wall.points', 'impact',
                            'absorbing_wall', 'points=100')

    def test_sweep_by_name(self):
        with tempfile.TemporaryDirectory() as folder:
            table = self.output_of('sweep', 'collision', 'points=50', 'velocity=0.05,0.1',
                                   '--output', os.path.join(folder, 'runs.csv'))
        self.assertEqual(table.split()[:2], ['impact.velocity', 'restitution'])
        self.assertEqual(len(table.splitlines()), 3)

    def test_shards_by_name(self):
        with tempfile.TemporaryDirectory() as folder:
            parts, table = (os.path.join(folder, name) for name in ('parts', 'all.csv'))
            sweep = ('sweep', 'collision', 'points=50', 'velocity=0.05', 'seed=1,2')
            self.assertEqual(self.output_of(*sweep, '--output', parts, '--shard', '1/2'),
                             'shard 1/2: 1 runs done\n')
            self.assertIn('1 of 2 runs done, 0 failed, 1 left\n',
                          self.output_of(*sweep, '--output', parts, '--status', '--text'))
            done = run(*sweep, '--collect', '--output', parts, table)
            self.assertEqual(done.returncode, 1)
            self.assertIn(': 1 of 2 runs are missing: shard 2/2 has 0 of 1\n', done.stderr)
            self.output_of(*sweep, '--output', parts, '--shard', '2/2')
            self.output_of(*sweep, '--collect', '--output', parts, table)
            self.assert_refused('FILE.csv is missing', *sweep, '--collect', '--output', parts)
            self.assert_refused('--shard excludes --status', *sweep, '--output', parts, '--status',
                                '--shard', '1/2')

    def test_shards_of_figures(self):
        for figure, runs in (('figure2', 112), ('figure3', 220), ('figure6', 180), ('oblique', 132)):
            status = json.loads(self.output_of('reproduce', figure, '--lattices', '2', '--output',
                                               '/nowhere', '--status', '--json'))
            self.assertEqual((status['runs'], status['shards']), (runs, 0))
            self.assertEqual(status['folder'], '/nowhere/' + figure + '_shards')
        self.assert_refused('all: is not divided into shards, allowed: figure2, figure3, '
                            'figure6 or oblique', 'reproduce', 'all', '--output', '/nowhere', '--status')

    def test_keys_of_a_scene(self):
        text = self.output_of('impact', 'collision', '--keys', 'velocity=0.02')
        self.assertIn('  impact.velocity = 0.02 c  (number in [1e-09, 1])\n', text)
        self.assertNotIn('load.P', text)

    def test_suggestions(self):
        self.assert_refused('velocty: unknown key (did you mean impact.velocity?)', 'impact',
                            'collision', 'velocty=0.1')
        self.assert_refused('(did you mean --output?)', 'impact', 'collision', '--outptu=x')
        self.assert_refused('(did you mean --animate?)', 'plot_impact', 'run', '--anmate', 'x.gif')
        self.assert_refused('(did you mean --jobs?)', 'sweep', 'collision', '--output', 'x.csv',
                            '--job', '2')

    def test_si(self):
        result = yaml.safe_load(self.output_of('impact', *SMALL, '--si', DISK))
        units = yaml.safe_load(self.output_of('units', *DISK.split(',')))
        self.assertEqual(units['units']['force'], 'N')
        self.assertAlmostEqual(result['si']['peak_force'] / units['force'], result['peak_force'])
        self.assertAlmostEqual(result['si']['velocity'] / units['speed'], 0.05)
        self.assertIn("Poisson's ratio fixed near 0.276",
                      self.output_of('impact', *SMALL, '--si', DISK, '--text'))

    def test_units_there_and_back(self):
        """A scene made from SI gives back what was asked for."""
        keys = yaml.safe_load(self.output_of('units', *DISK.split(','), 'velocity=1.5'))['scene']
        velocity = 'impact.velocity={}'.format(keys['impact.velocity'])
        result = yaml.safe_load(self.output_of('impact', 'collision', 'points=100', velocity,
                                               '--si', DISK))
        self.assertAlmostEqual(result['si']['velocity'], 1.5)
        self.assert_refused('velocty: unknown key (did you mean velocity?)', 'units',
                            *DISK.split(','), 'velocty=1')

    def test_version(self):
        version = ElementTree.parse(str(SOURCE / 'package.xml')).find('version').text
        for name in TOOLS + SCRIPTS + NODES:
            self.assertEqual(self.output_of(name, '--version'), name + ' ' + version + '\n')

    def test_help_of_nodes_without_a_master(self):
        for name in NODES:
            text = self.output_of(name, '--help')
            self.assertIn('run_status', text)
            if name != 'viewer_node':  # which has no parameters
                self.assertRegex(text, r'\n  timeout = 30(\.0)? s  \(number in')

    def complete(self, *words):
        """What bash offers for the last word."""
        script = '''
            . {}
            compopt() {{ :; }}
            COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1))
            _lattice_impact{}
            echo "${{COMPREPLY[*]}}"
        '''.format(SOURCE / 'src/tools/completion.bash',
                   '_rosrun' if words[0] == 'rosrun' else '')
        done = subprocess.run(['bash', '--norc', '-i', '-c', script, 'bash', *words],
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, universal_newlines=True, timeout=TIMEOUT,
                              env=dict(ENVIRONMENT,
                                       CMAKE_PREFIX_PATH=str(PROGRAMS.parents[1])))
        return re.split(r'\s+', done.stdout.strip())

    def test_completion(self):
        self.assertEqual(self.complete('impact', 'co'), ['collision', 'contact'])
        self.assertEqual(self.complete('rosrun', 'lattice_impact', 'impact', 'st'), ['stretch'])
        self.assertEqual(self.complete('rosrun', 'lattice_impact', 'impact', 'contact', 'load.'),
                         ['load.P=', 'load.hold_rotation='])
        self.assertEqual(self.complete('sweep', 'collision', '--jo'), ['--jobs'])
        self.assertEqual(self.complete('sweep', 'collision', '--sh'), ['--shard'])
        self.assertEqual(self.complete('submit', 'sw'), ['sweep'])
        self.assertEqual(self.complete('submit', '--ta'), ['--tasks'])
        self.assertEqual(self.complete('submit', 'sweep', 'co'), ['collision', 'contact'])
        self.assertEqual(self.complete('submit', '--tasks', '4', 'sweep', 'contact', 'load.'),
                         ['load.P=', 'load.hold_rotation='])
        self.assertEqual(self.complete('units', 'den'), ['density='])


if __name__ == '__main__':
    unittest.main()
