#!/usr/bin/python3
"""Does harm to recordings, bags and results, at random, on a machine that is kept busy.

Prints what was done how often, how often something was lost and how often a number was wrong
without a word; ends with 1 if anything was. The seed that it prints repeats the choices, not the
instants of a busy machine.
"""

import argparse
import collections
import contextlib
import copy
import math
import os
import pathlib
import random
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

import rosbag
import yaml

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / 'ros'))
import programs  # noqa: E402

TIMEOUT = 120.0  # s, far above what anything here takes
SMALL = {'disk.points': 30, 'impact.velocity': [0.02, 0.05], 'output.period': 0.5}


class Fault(Exception):
    """What should not have happened."""


def require(condition, what):
    if not condition:
        raise Fault(what)


def run(name, *arguments):
    return subprocess.run([programs.program(name), *map(str, arguments)], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, universal_newlines=True, errors='replace',
                          timeout=TIMEOUT)


def start(name, *arguments):
    return subprocess.Popen([programs.program(name), *map(str, arguments)],
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                            universal_newlines=True)


def free_port():
    with socket.socket() as any_port:
        any_port.bind(('localhost', 0))
        return any_port.getsockname()[1]


def processes_below(ancestor, name):
    """Those of this name, in the words of /proc, that it has started or that its own have."""
    parents, names = {}, {}
    for stat in pathlib.Path('/proc').glob('[0-9]*/stat'):
        try:
            number, rest = stat.read_text().split(' (', 1)
        except OSError:
            continue  # it has just ended
        own, rest = rest.rsplit(') ', 1)
        parents[int(number)], names[int(number)] = int(rest.split()[1]), own
    below = {ancestor}
    for _ in range(3):
        below |= {number for number, parent in parents.items() if parent in below}
    return [number for number in below if names.get(number) == name]


def memory_of(number):
    """kB; 0 when it has ended."""
    try:
        status = pathlib.Path('/proc/{}/status'.format(number)).read_text()
    except OSError:
        return 0
    found = re.search(r'VmRSS:\s+(\d+)', status)
    return int(found[1]) if found else 0


def without_wall_time(csv):
    lines = [line.split(',') for line in csv.splitlines()]
    column = lines[0].index('wall_time')
    return [line[:column] + line[column + 1:] for line in lines]


def kill_later(process, seconds):
    """False when it has ended by then."""
    try:
        process.wait(seconds)
        return False
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
        return True
    finally:
        process.stdout.close()
        process.stderr.close()


class Faults:
    """One method a fault: says what was said, or raises Fault."""

    def __init__(self, folder, draw):
        self.folder = folder
        self.draw = draw
        self.bag = folder / 'run.bag'
        self.log = folder / 'launch.log'
        self.namespace = '/faults'
        with self.simulate() as node:
            require(node.wait() == 0, node.stderr())
        self.good = self.bag.read_bytes()
        self.original = folder / 'good.bag'
        self.original.write_bytes(self.good)
        self.damaged = folder / 'damaged.bag'
        self.report = run('analyse_bag', self.bag)
        require(self.report.returncode == 0, self.report.stderr)
        self.numbers = self.numbers_of(self.report.stdout)

    def simulate(self, **parameters):
        if programs.rospy.has_param(self.namespace):
            programs.rospy.delete_param(self.namespace)
        return programs.simulation(self.namespace, 'collision', SMALL,
                                   **dict({'bag': str(self.bag)}, **parameters))

    @staticmethod
    def numbers_of(report):
        """The numbers of each run."""
        document = yaml.safe_load(report) or {}
        content = next(iter(document.values()), {})
        return {entry['run']: {key: value for key, value in entry.items()
                               if isinstance(value, float)} for entry in content.get('runs', [])}

    @staticmethod
    def without_order(report):
        """The runs may end in another order, and a fit then says that it came after another one."""
        content = next(iter(yaml.safe_load(report).values()))
        for fit in content.get('law_fits', []):
            del fit['run']
        return content['topics'], sorted(map(repr, content['runs'])), repr(content.get('law_fits'))

    @contextlib.contextmanager
    def launch(self, **arguments):
        """roslaunch, with its output in a file: a full pipe would stop the nodes."""
        words = ['{}:={}'.format(name, value) for name, value in arguments.items()]
        with open(str(self.log), 'w') as log:
            process = subprocess.Popen(['roslaunch', '-p', str(free_port()), programs.PACKAGE,
                                        'collision.launch', 'bag:=' + str(self.bag), *words],
                                       stdout=log, stderr=subprocess.STDOUT)
            try:
                yield process
                process.wait(TIMEOUT)
            finally:
                process.send_signal(signal.SIGINT)
                process.wait()

    def clear(self):
        """Takes away what an earlier fault has left."""
        for path in self.folder.glob('run.*'):
            path.unlink()

    def recording(self):
        """Recording of four impacts"""
        with self.launch(N=60, velocity='[0.01,0.02,0.03,0.05]'):
            pass
        analysis = run('analyse_bag', self.bag)
        require(analysis.returncode == 0, self.log.read_text() + analysis.stderr)
        return 'complete'

    def killed_node(self):
        """A node of a recorded run killed"""
        self.bag.write_bytes(self.good)
        victim = self.draw.choice(['simulation_node', 'recorder_node', 'analysis_node'])
        with self.launch(N=300, velocity=0.02, max_rate=200) as process:
            active = self.folder / 'run.bag.active'
            deadline = time.monotonic() + TIMEOUT
            while not active.exists() and process.poll() is None and time.monotonic() < deadline:
                time.sleep(0.01)
            time.sleep(self.draw.uniform(0.0, 3.0))
            for child in processes_below(process.pid, victim):
                os.kill(child, signal.SIGKILL)
        output = self.log.read_text()
        if self.bag.read_bytes() != self.good:
            require(run('analyse_bag', self.bag).returncode == 0, 'replaced by less: ' + output)
            return 'had ended'
        said = {'simulation_node': 'its end was not announced',
                'recorder_node': 'gone in mid-run', 'analysis_node': 'gone in mid-run'}[victim]
        early = ('lattice_impact/', 'nothing was recorded')
        require(said in output or any(word in output for word in early), victim + ': ' + output)
        return said if said in output else 'killed before the first message'

    def full_disk(self):
        """Disk full"""
        self.bag.write_bytes(self.good)
        size = self.draw.randrange(1000, len(self.good) + 20000)
        with programs.limited_to(size, 'simulation_node'), self.simulate() as node:
            code = node.wait()
            said = node.stderr().strip()
        if code == 0:
            require(run('analyse_bag', self.bag).stdout == self.report.stdout, 'another bag')
            return 'fits'
        require(code in (1, 2) and len(said.splitlines()) == 1 and 'cannot be written' in said, said)
        require(self.bag.read_bytes() == self.good, 'the good bag was replaced')
        return 'cannot be written'

    def records(self):
        """Topic, message and stamp of all that is in the good bag."""
        with rosbag.Bag(str(self.original)) as bag:
            return [list(record) for record in bag.read_messages()]

    def write_damaged(self, records):
        with rosbag.Bag(str(self.damaged), 'w') as bag:
            for topic, message, stamp in records:
                bag.write(topic, message, stamp)

    def judge_records(self, records):
        self.write_damaged(records)
        return self.judge()

    def judge(self):
        """Whatever was done to the damaged bag, no number may differ without a word."""
        analysis = run('analyse_bag', self.damaged)
        require(analysis.returncode in (0, 1, 2), 'exit code {}'.format(analysis.returncode))
        if analysis.returncode == 0 and self.without_order(analysis.stdout) == self.without_order(
                self.report.stdout):
            return 'no harm'
        require(analysis.stderr.startswith('analyse_bag: '), 'not a word: ' + analysis.stdout)
        if analysis.returncode != 2:
            for number, values in self.numbers_of(analysis.stdout).items():
                told = 'run {}:'.format(number) in analysis.stderr
                for key, value in values.items():
                    true = self.numbers.get(number, {}).get(key, math.nan)
                    same = value == true or math.isnan(value)
                    require(same or told, 'run {}: {} {} for {}: {}'.format(
                        number, key, value, true, analysis.stderr))
        return 'told'

    def damaged_bytes(self):
        """Bytes of a bag changed, taken away, or the file cut"""
        content = bytearray(self.good)
        place = self.draw.randrange(len(content))
        kind = self.draw.randrange(4)
        if kind == 0:
            for _ in range(self.draw.choice([1, 3, 10])):
                content[self.draw.randrange(len(content))] = self.draw.randrange(256)
        elif kind == 1:
            content[place] ^= 1 << self.draw.randrange(8)
        elif kind == 2:
            del content[place:]
        else:
            del content[place:place + self.draw.randrange(1, 200)]
        self.damaged.write_bytes(content)
        return self.judge()

    def damaged_message(self):
        """A message of a bag changed, left out, doubled or put elsewhere"""
        records = self.records()
        place = self.draw.randrange(len(records))
        kind = self.draw.randrange(8)
        if kind == 0:
            del records[place]
        elif kind == 1:
            records.insert(place, copy.copy(records[place]))
        elif kind == 2:
            other = self.draw.randrange(len(records))
            records[place][1], records[other][1] = records[other][1], records[place][1]
            records[place][0], records[other][0] = records[other][0], records[place][0]
        else:
            records[place][1] = copy.deepcopy(records[place][1])
            self.damage(records[place][1])
        return self.judge_records(records)

    def damage(self, message):
        """One field of it, or one element of an array."""
        slot = self.draw.choice([name for name in message.__slots__ if name != 'header'])
        value = getattr(message, slot)
        if hasattr(value, '__slots__'):
            self.damage(value)
        elif isinstance(value, (list, tuple)):
            value = list(value)
            kind = self.draw.randrange(3)
            if value and kind == 0:
                del value[self.draw.randrange(len(value))]
            elif value and kind == 1:
                place = self.draw.randrange(len(value))
                value[place] = self.other(value[place])
            else:
                value.append(value[-1] if value else 0)
            setattr(message, slot, value)
        else:
            setattr(message, slot, self.other(value))

    def other(self, value):
        if isinstance(value, str):
            return value[:-1] if value else 'x'
        if isinstance(value, float):
            return self.draw.choice([math.nan, math.inf, -value, 0.0, value * (1 + 1e-9),
                                     value + self.draw.gauss(0.0, 1.0)])
        if isinstance(value, bool):
            return not value
        return self.draw.choice([0, 1, value ^ 1, value + 1])

    def missing_part(self):
        """A run or a topic of a bag missing"""
        records = self.records()
        if self.draw.random() < 0.5:
            absent = self.draw.randrange(2)
            kept = [record for record in records if record[1].run != absent]
        else:
            absent = self.draw.choice(sorted({record[0] for record in records}))
            kept = [record for record in records if record[0] != absent]
        if str(absent).endswith('/scalars'):
            return self.judge_without_scalars(kept)
        said = self.judge_records(kept)
        require(said == 'told', '{} is missing: {}'.format(absent, said))
        return said

    def judge_without_scalars(self, records):
        """They are published only while somebody listens, so that none at all is no fault: every
        number is still the true one."""
        self.write_damaged(records)
        analysis = run('analyse_bag', self.damaged)
        require(analysis.returncode == 0, 'exit code {}'.format(analysis.returncode))
        _, *found = self.without_order(analysis.stdout)
        _, *true = self.without_order(self.report.stdout)
        require(found == true, 'other numbers without scalars: ' + analysis.stdout)
        return 'the same numbers'

    SWEEP = (pathlib.Path(programs.scene_file('collision')), 'disk.points=60', 'seed=1:12:12')

    def reference_sweep(self):
        reference = self.folder / 'reference.csv'
        if not reference.exists():
            require(run('sweep', *self.SWEEP, '--output', reference).returncode == 0, 'no sweep')
        return without_wall_time(reference.read_text())

    def killed_sweep(self):
        """A sweep killed, and taken up again"""
        reference = self.reference_sweep()
        csv = self.folder / 'sweep.csv'
        csv.unlink(missing_ok=True)
        killed = kill_later(start('sweep', *self.SWEEP, '--output', csv),
                            self.draw.uniform(0.0, 0.4))
        again = run('sweep', *self.SWEEP, '--output', csv)
        require(again.returncode == 0, again.stderr)
        require(without_wall_time(csv.read_text()) == reference, 'another table')
        return 'goes on' if killed else 'had ended'

    def two_writers(self):
        """Two programs with one output"""
        output = self.folder / 'both'
        scene = programs.scene_file('collision')
        command = self.draw.choice([
            ('sweep', *self.SWEEP, '--output', output),
            ('impact', scene, 'disk.points=3000', '--output', output)])
        first = start(*command)
        time.sleep(self.draw.uniform(0.0, 0.3))
        second = run(*command)
        _, errors = first.communicate(timeout=TIMEOUT)
        codes = (first.returncode, second.returncode)
        shutil.rmtree(output) if output.is_dir() else output.unlink()
        if codes == (0, 0):
            return 'one after the other'
        require(sorted(codes) == [0, 2], str(codes) + errors + second.stderr)
        require('another process is writing to it' in errors + second.stderr, errors)
        return 'another process is writing to it'

    def killed_impact(self):
        """impact --output killed"""
        contents = {}
        for points in (2000, 3000):
            whole = self.folder / 'of_{}'.format(points)
            if not whole.exists():
                self.impact(points, whole).communicate(timeout=TIMEOUT)
            contents[points] = {path.name: path.read_bytes() for path in whole.iterdir()
                                if path.name != 'result.yaml'}  # has its wall time
        output = self.folder / 'impact'
        shutil.rmtree(str(output), ignore_errors=True)
        shutil.copytree(str(self.folder / 'of_2000'), str(output))
        process = self.impact(3000, output)
        while not (output / 'result.yaml.part').exists() and process.poll() is None:
            pass  # the files are written within milliseconds
        killed = kill_later(process, self.draw.uniform(0.0, 0.03))
        there = [name for name in contents[2000] if (output / name).exists()]
        of = {points for points in contents for name in there
              if (output / name).read_bytes() == contents[points][name]}
        require(len(of) < 2, 'files of two results')
        if (output / 'result.yaml').exists():
            require(len(there) == len(contents[2000]) and len(of) == 1, 'half a result')
        return 'one result' if killed else 'had ended'

    @staticmethod
    def impact(points, output):
        return start('impact', programs.scene_file('collision'), 'disk.points={}'.format(points),
                     'impact.velocity=0.05', 'output.period=0.001', '--output', output)

    def soak(self):
        """2000 impacts through both nodes and the recorder, twice"""
        scene = self.folder / 'soak.yaml'
        scene.write_text(yaml.safe_dump({
            'scene': 'collision', 'seed': list(range(1, 2001)), 'disk': {'points': 30},
            'impact': {'velocity': 0.05}, 'output': {'period': 0.5}}))
        reports = set()
        for _ in range(2):
            sizes = collections.defaultdict(list)  # kB
            with self.launch(scene=scene) as process:
                while process.poll() is None:
                    for name in ('simulation_node', 'analysis_node', 'recorder_node'):
                        for number in processes_below(process.pid, name):
                            sizes[name].append(memory_of(number))
                    time.sleep(0.5)
            analysis = run('analyse_bag', self.bag)
            require(analysis.returncode == 0, analysis.stderr)
            reports.add(analysis.stdout)
            for name, values in sizes.items():
                growth = values[-2] - values[len(values) // 2]
                require(growth < 4000, '{} grows by {} kB'.format(name, growth))
        require(len(reports) == 1, 'other numbers')
        return 'the same bits'


KINDS = (Faults.recording, Faults.killed_node, Faults.full_disk, Faults.damaged_bytes,
         Faults.damaged_message, Faults.missing_part, Faults.killed_sweep, Faults.two_writers,
         Faults.killed_impact, Faults.soak)


def busy_loops(count):
    """Each in a session of its own, since the scheduler shares by session."""
    return [subprocess.Popen([sys.executable, '-c', 'while True: pass'], start_new_session=True)
            for _ in range(count)]


def do_harm(faults, kinds, seconds, tries):
    """Each kind once, then all in turn until the time is over or each has its tries."""
    said = {kind: collections.Counter() for kind in kinds}
    wrong = collections.Counter()
    deadline = time.monotonic() + seconds
    for number in range(tries):
        for kind in kinds:
            if number > 0 and time.monotonic() > deadline:
                return said, wrong
            faults.clear()
            try:
                said[kind][kind(faults)] += 1
            except (Fault, AssertionError, subprocess.TimeoutExpired) as fault:
                wrong[kind] += 1
                print('{}: {}'.format(kind.__doc__, fault), file=sys.stderr)
    return said, wrong


def main():
    names = [kind.__name__ for kind in KINDS]
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--seconds', type=float, default=60.0, help='time for all')
    parser.add_argument('--tries', type=int, default=10 ** 9, help='most of each fault')
    parser.add_argument('--only', choices=names, nargs='+', default=names[:-1],
                        help='all but the soak unless given')
    parser.add_argument('--seed', type=int, default=random.randrange(2 ** 32))
    parser.add_argument('--load', type=int, default=4, help='busy loops beside')
    options = parser.parse_args()
    print('seed', options.seed)
    os.environ['ROS_MASTER_URI'] = 'http://localhost:{}'.format(free_port())
    core = subprocess.Popen(['roscore', '-p', os.environ['ROS_MASTER_URI'].rsplit(':', 1)[1]],
                            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    loops = busy_loops(options.load)
    try:
        with tempfile.TemporaryDirectory() as folder:
            programs.poll_until(is_master_there, 'master')
            faults = Faults(pathlib.Path(folder), random.Random(options.seed))
            kinds = [kind for kind in KINDS if kind.__name__ in options.only]
            said, wrong = do_harm(faults, kinds, options.seconds, options.tries)
    finally:
        for loop in loops:
            loop.kill()
            loop.wait()
        core.send_signal(signal.SIGINT)
        core.wait()
    print('| fault | tries | lost or wrong in silence | what was said |\n|---|---|---|---|')
    for kind in kinds:
        print('| {} | {} | {} | {} |'.format(
            kind.__doc__, sum(said[kind].values()) + wrong[kind], wrong[kind],
            ', '.join('{} ({})'.format(*item) for item in said[kind].most_common())))
    sys.exit(1 if wrong else 0)


def is_master_there():
    try:
        return programs.rospy.get_param('/run_id', '') != ''
    except OSError:
        return False


if __name__ == '__main__':
    main()
