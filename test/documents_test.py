#!/usr/bin/env python3
"""Runs every command line of README.md and doc/*.md, and checks links and pictures.

The language of a fenced block says what it holds: `bash` commands, `console` commands behind `$ `
with their output, others none. A block without a language holds commands if RULES know its first
line. The commands of a page run in order in one folder, made for it, that shows the checkout's
files. RULES say how each is run; a command without a rule is an error.
"""

import concurrent.futures
import os
import re
import shlex
import shutil
import socket
import subprocess
import sys
import tempfile
import threading
import unittest
import urllib.parse

import roslaunch.config
import roslaunch.xmlloader
from roslib.packages import find_node

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
PAGES = ['README.md'] + sorted('doc/' + name for name in os.listdir(os.path.join(ROOT, 'doc'))
                               if name.endswith('.md'))
TIMEOUT = 120  # s, far above what any of them takes

# --- what to do with a command -----------------------------------------------------------------


def run(*replacements, codes=(0,)):
    """Runs it, with these pairs of expression and text replaced, and expects one of the codes."""
    def action(command, page):
        for expression, text in replacements:
            command = re.sub(expression, text, command)
        page.shell(command, codes)
    return action


def start(command, page):
    """Runs it for a moment: bad options end a program at once with 2."""
    page.shell('timeout --signal=KILL 0.5 ' + command, (0, 137))


def only_find(command, page):
    """Takes long, or needs what a test does not have: its files must be there, or their sources."""
    for word in shlex.split(command, comments=True):
        source = re.sub('^build/(test)/(bench_.*)', r'\1/bench/\2.cpp', word)
        if re.match('(test|launch|src)/', source) and not page.has(source):
            raise AssertionError('there is no ' + source)


def only_list(command, page):
    """Lists the tests that the filter of such a program finds: at least one."""
    page.shell('test "$({} --gtest_list_tests)"'.format(
        re.sub('LATTICE_IMPACT_WRITE_DOCUMENTS=1 |--gtest_output=xml', '', command)))


def pass_over(command, page):
    pass


def launch(command, page):
    """Reads the launch file as roslaunch does, its check of the arguments included, and lays a
    small recording where it records to or replays from. rviz, which may not be there, stays out."""
    command = command.replace('$PWD', page.folder).replace('rviz:=true', 'rviz:=false')
    line = shlex.split(command, comments=True)
    file = os.path.join(ROOT, 'launch', line[2])
    if line[1] != 'lattice_impact' or not os.path.exists(file):
        raise AssertionError('there is no such launch file')
    if 'record:=false' not in line:
        page.provide_bag(next((word[5:] for word in line if word.startswith('bag:=')),
                              line[2].replace('.launch', '.bag')))
    page.parse_launch_file(file, line)


QUICK_DISK = (r'^(?!.*points=).*$', r'\g<0> disk.points=100')
QUICK_WALL = (r'^(?!.*wall.points=).*$', r'\g<0> wall.points=100')
FEW_SEEDS = (r'seed=1:\d+:\d+', 'seed=1:2:2')

# The first that matches holds.
RULES = (
    (r'bash (launch/demo|test/run)\.sh', only_find),
    (r'(sudo )?(apt|apt-get|dpkg) ', pass_over),
    (r'(source|\.) |cmake |ctest |git |roscore|\(?cd |cpack|make |catkin_make', pass_over),
    (r'mkdir |cat > |A=', run()),
    (r'(LATTICE_IMPACT_WRITE_DOCUMENTS=1 )?build/test/test_\w+ ', only_list),
    (r'(taskset -c 0 )?(build/test/bench_|test/bench/)\w+', only_find),
    (r'/usr/bin/python3 \w+\.py$', run()),
    (r'test/mutants/mutants\.py', run((r'--only .*', '--list'))),
    (r'export |PATH=|ldd |rsync |parallel ', pass_over),
    (r'rosrun lattice_impact plot_sweep results/', pass_over),
    (r'(SBATCH_\w+=\S+ )?rosrun lattice_impact submit ', pass_over),
    (r'rosbag |rostopic |rqt_plot |rosrun plotjuggler |(ROS_NAMESPACE=\w+ )?rviz ', pass_over),
    (r'roslaunch ', launch),
    (r'rosrun lattice_impact (simulation|viewer)_node ', pass_over),
    (r'rosrun lattice_impact impact .*velocity=1e-9', run(codes=(2,))),
    (r'rosrun lattice_impact impact .*disk\.file=', run()),
    (r'rosrun lattice_impact impact .*absorbing_wall', run(QUICK_DISK, QUICK_WALL)),
    (r'rosrun lattice_impact impact .*stretch', run()),
    (r'rosrun lattice_impact impact ', run(QUICK_DISK)),
    (r'rosrun lattice_impact sweep \$', start),
    (r'rosrun lattice_impact sweep .*--collect', run(
        FEW_SEEDS, (r'sweep \w+', r'\g<0> disk.points=100'))),
    (r'rosrun lattice_impact sweep .*stretch', run(FEW_SEEDS)),
    (r'rosrun lattice_impact sweep disk_on_disk ', run(FEW_SEEDS, QUICK_DISK, (r'velocity=\S+', 'velocity=0.02,0.05'), (r'angle=\S+', 'angle=10,60'))),
    (r'rosrun lattice_impact sweep row_of_disks ', run(
        FEW_SEEDS, QUICK_DISK, (r'velocity=\S+', 'velocity=0.02'), (r'wall\.a=\S+', 'wall.a=300,1000'))),
    (r'rosrun lattice_impact sweep oblique ', run(
        FEW_SEEDS, (r'angle=\S+', 'angle=0,60'), (r'k_a=\S+', 'k_a=0.1'))),
    (r'rosrun lattice_impact sweep .*seed=', run(FEW_SEEDS, QUICK_DISK)),
    (r'rosrun lattice_impact sweep ', run(QUICK_DISK)),
    (r'rosrun lattice_impact reproduce ', start),
    (r'rosrun lattice_impact (work_precision|stability|accuracy_check) ', start),
    (r'rosrun lattice_impact plot_figures ', pass_over),
    (r'rosrun lattice_impact to_lammps ', run((r'points=\d+', 'points=100'))),
    (r'rosrun lattice_impact from_lammps |(srun|mpirun) ', pass_over),
    (r'rosrun lattice_impact (analyse_bag|convert|units) ', run()),
    (r'rosrun lattice_impact plot_(impact|sweep) .*--animate', start),
    (r'rosrun lattice_impact plot_(impact|sweep) ', run()),
)


def rule_of(command):
    return next((action for expression, action in RULES if re.match(expression, command)), None)


# --- pages -------------------------------------------------------------------------------------


def recording(folder):
    """A bag of three small impacts, by a master of its own."""
    with socket.socket() as free:
        free.bind(('localhost', 0))
        port = free.getsockname()[1]
    bag = os.path.join(folder, 'recording.bag')
    environment = dict(os.environ, ROS_MASTER_URI='http://localhost:{}'.format(port))
    done = subprocess.run(
        ['roslaunch', '-p', str(port), os.path.join(ROOT, 'launch', 'collision.launch'), 'N:=30',
         'velocity:=[0.05, 0.1, 0.2]', 'bag:=' + bag], env=environment, stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT, universal_newlines=True, timeout=TIMEOUT)
    if not os.path.exists(bag):
        raise AssertionError('nothing was recorded: ' + done.stdout)
    return bag


def blocks(text):
    """Language and lines of each fenced block."""
    for _, language, body in re.findall(r'^( *)```(\w*)\n(.*?)^\1```', text, re.M | re.S):
        yield language, body.splitlines()


def without_comment(line):
    return re.sub(r'(^|\s)#\s.*', '', line).rstrip()


def command_lines(language, lines):
    """The commands of a block, each as one line, or several with a here document."""
    if language == 'console':
        lines = [line[2:] for line in lines if line.startswith('$ ')]
    elif language != 'bash' and not (language == '' and lines and rule_of(lines[0].strip())):
        return
    lines = iter(lines)
    for line in lines:
        line = without_comment(line)
        while line.endswith('\\'):
            line = line[:-1].rstrip() + ' ' + without_comment(next(lines)).strip()
        here = re.search(r"<<'?(\w+)'?$", line)
        while here:
            body = next(lines)
            line += '\n' + body
            if body.strip() == here[1]:
                break
        if line.strip():
            yield line.strip()


class Page:
    """The commands of one page, in a folder of their own."""

    _only_one = threading.Lock()

    def __init__(self, name, folder):
        self.name = name
        self.folder = folder
        self.failures = []
        os.makedirs(os.path.join(folder, 'build'))
        for entry in os.listdir(ROOT) + ['build/test']:
            if not entry.startswith('.') and entry != 'build':
                os.symlink(os.path.join(ROOT, entry), os.path.join(folder, entry))
        self._variables = os.path.join(folder, '.variables')
        open(self._variables, 'w').close()

    def run_all(self):
        with open(os.path.join(ROOT, self.name)) as file:
            text = file.read()
        for language, lines in blocks(text):
            for command in command_lines(language, lines):
                self._run(command)
        return self

    def _run(self, command):
        for part in command.split(' && ') if '<<' not in command else [command]:
            action = rule_of(part)
            try:
                if action is None:
                    raise AssertionError('no rule of documents_test.py knows this command')
                action(part, self)
            except (AssertionError, subprocess.TimeoutExpired) as failure:
                self.failures.append('{}: {}\n    {}'.format(self.name, part, failure))

    def provide_bag(self, name):
        """A small recording under this name, if the page has none there."""
        if not self.has(name):
            shutil.copy(RECORDING.result(), os.path.join(self.folder, name))

    def has(self, path):
        return os.path.exists(os.path.join(self.folder, path))

    def shell(self, command, codes=(0,)):
        """Runs it. Variables that it sets are there for the commands after it."""
        command = re.sub(r'rosrun lattice_impact (\w+)', lambda match: program(match[1]), command)
        for bag in re.findall(r'[\w/]+\.bag\b', command):
            self.provide_bag(bag)
        script = 'set -a; . {0}\n{1}\ncode=$?; set | grep "^[A-Z]=" > {0}; exit $code'.format(
            self._variables, command)
        done = subprocess.run(['bash', '-c', script], cwd=self.folder, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              universal_newlines=True, timeout=TIMEOUT)
        if done.returncode not in codes:
            raise AssertionError('exit code {}: {}'.format(done.returncode, done.stdout[-500:]))

    def parse_launch_file(self, file, line):
        with self._only_one:  # what a launch file checks is the command line and folder of all
            before = sys.argv, os.environ.get('PWD')
            sys.argv, os.environ['PWD'] = [line[0], file] + line[3:], self.folder
            errors = sys.stderr
            try:
                with tempfile.TemporaryFile('w+') as said:
                    sys.stderr = said
                    try:
                        roslaunch.xmlloader.XmlLoader().load(
                            file, roslaunch.config.ROSLaunchConfig(), argv=line[3:], verbose=False)
                    except SystemExit:
                        said.seek(0)
                        raise AssertionError(said.read())
                    except roslaunch.xmlloader.XmlParseException as error:
                        raise AssertionError(error)
            finally:
                sys.stderr = errors
                sys.argv, os.environ['PWD'] = before


PROGRAMS = {}


def program(name):
    if name not in PROGRAMS:
        found = find_node('lattice_impact', name)
        if not found:
            raise AssertionError(name + ' is not built')
        PROGRAMS[name] = found[0]
    return PROGRAMS[name]


# --- links -------------------------------------------------------------------------------------


def without_code(text):
    return re.sub(r'`[^`\n]*`', '', re.sub(r'^( *)```.*?^\1```', '', text, flags=re.M | re.S))


def anchors(text):
    """The anchors that GitHub gives the headings of a page."""
    found = set()
    for heading in re.findall(r'^#+ +(.*?) *$', re.sub(r'^( *)```.*?^\1```', '', text,
                                                       flags=re.M | re.S), re.M):
        heading = re.sub(r'\[([^]]*)\]\([^)]*\)', r'\1', heading).lower()
        slug = re.sub(r'[^\w\- ]', '', heading).replace(' ', '-')
        number = 0
        while slug + ('-{}'.format(number) if number else '') in found:
            number += 1
        found.add(slug + ('-{}'.format(number) if number else ''))
    return found


def link_failures(name):
    with open(os.path.join(ROOT, name)) as file:
        text = without_code(file.read())
    for picture, label, target in re.findall(r'(!?)\[([^]]*)\]\(([^)\s]+)\)', text):
        if re.match(r'[a-z]+:', target):
            continue
        if picture and not label.strip():
            yield '{}: the picture {} has no text'.format(name, target)
        path, _, anchor = target.partition('#')
        path = urllib.parse.unquote(path)
        there = os.path.normpath(os.path.join(os.path.dirname(name), path)) if path else name
        if not os.path.exists(os.path.join(ROOT, there)):
            yield '{}: there is no {}'.format(name, there)
        elif anchor and there.endswith('.md'):
            with open(os.path.join(ROOT, there)) as file:
                if anchor not in anchors(file.read()):
                    yield '{}: {} has no heading {}'.format(name, there, anchor)


class Documents(unittest.TestCase):

    def test_commands(self):
        global RECORDING
        for name in ('impact', 'sweep', 'analyse_bag'):
            program(name)
        with tempfile.TemporaryDirectory() as folder, \
                concurrent.futures.ThreadPoolExecutor(2) as threads:
            RECORDING = threads.submit(recording, folder)
            pages = [Page(name, os.path.join(folder, name.replace('/', '_'))) for name in PAGES]
            failures = sum((page.failures for page in threads.map(Page.run_all, pages)), [])
        self.assertEqual('', '\n'.join(failures))

    def test_links(self):
        failures = [failure for name in PAGES for failure in link_failures(name)]
        self.assertEqual('', '\n'.join(failures))

    def test_code_is_not_wider_than_a_page(self):
        for name in PAGES:
            with open(os.path.join(ROOT, name)) as file:
                for language, lines in blocks(file.read()):
                    for line in lines if language in ('bash', 'yaml', 'python') else ():
                        self.assertLessEqual(len(line), 100, name + ': ' + line)

    def test_the_front_page_is_short(self):
        with open(os.path.join(ROOT, 'README.md')) as file:
            self.assertLessEqual(len(file.readlines()), 200)


if __name__ == '__main__':
    unittest.TestCase.maxDiff = None
    unittest.main()
