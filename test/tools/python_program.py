"""What the tests of the Python programs share. Their first argument is the program impact."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TOOLS = ROOT / 'src/tools'
sys.path.insert(0, str(TOOLS))

SMALL_WALL = ['absorbing_wall', 'disk.points=30', 'wall.points=40', 'impact.velocity=0.05',
              'output.period=0.5']
SMALL_DAMPED = ['collision', 'disk.points=30', 'material.eta=5', 'impact.velocity=0.05',
                'output.period=0.1']


def run(name, *arguments, **options):
    """A program of src/tools; stdout and stderr in one text."""
    command = [sys.executable, str(TOOLS / name), *map(str, arguments)]
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          universal_newlines=True, check=False, **options)


def simulate(folder, scene, *options):
    """The folder of impact --output."""
    file, *assignments = scene
    command = [IMPACT, str(ROOT / f'launch/scenes/{file}.yaml'), *assignments, '--output',
               str(folder), *options]
    subprocess.run(command, stdout=subprocess.DEVNULL, check=True)
    return folder


class InFolder(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.folder = Path(directory.name)

    def assert_refused(self, done, text, exit_code=2):
        """In one line that matches."""
        self.assertEqual(done.returncode, exit_code, done.stdout)
        self.assertRegex(done.stdout, rf'\A[a-z_]+: .*{text}.*\n\Z')


IMPACT = None


def main():
    global IMPACT
    IMPACT = sys.argv.pop(1)
    unittest.main(module='__main__')
