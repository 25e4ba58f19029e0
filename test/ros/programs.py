"""What the tests of the nodes share: starting programs, hearing topics, reading results.

A scene is told by the name of its file and a dict of dotted keys that replace those of the file,
so that the nodes and the tools are given the same.
"""

import contextlib
import os
import resource
import signal
import subprocess
import tempfile
import threading
import time
import uuid
from io import BytesIO

import rosbag
import roslib.packages
import rospy
import yaml

PACKAGE = 'lattice_impact'
TIMEOUT = 60.0  # s, far above what anything here takes
NODE_TIMEOUT = 0.5 * TIMEOUT  # s, so that a node tells what it misses before the test gives up

SMALL_COLLISION = {'disk.points': 300, 'impact.velocity': 0.02}
SMALL_CONTACT = {'disk.points': 120, 'material.eta': 20}
SMALL_ABSORBING_WALL = {'disk.points': 120, 'wall.points': 140, 'impact.velocity': 0.05}
SMALL_ROW = {'disk.points': 60, 'impact.velocity': 0.05, 'wall.a': 1000.0}
ENDLESS_COLLISION = {'disk.points': 300, 'impact.velocity': 0.001}

IMPACT_RESULTS = ('restitution', 'contact_begin', 'contact_end', 'contact_duration', 'peak_force',
                  'impulse', 'spin_after', 'energy_restitution', 'tangential_velocity_after')


def program(name):
    found = roslib.packages.find_node(PACKAGE, name)
    if not found:
        raise AssertionError(name + ' is not built')
    return found[0]


def scene_file(scene):
    return os.path.join(roslib.packages.get_pkg_dir(PACKAGE), 'launch', 'scenes', scene + '.yaml')


def scene_parameters(scene, values):
    """The scene as the tree that the parameter server holds."""
    with open(scene_file(scene)) as file:
        tree = yaml.safe_load(file)
    for key, value in values.items():
        branch = tree
        *groups, leaf = key.split('.')
        for group in groups:
            branch = branch[group]
        branch[leaf] = value
    return tree


def without_module(name, folder):
    """An environment in which Python does not find this module, by a file in the folder."""
    with open(os.path.join(folder, name + '.py'), 'w') as file:
        file.write('raise ModuleNotFoundError("No module named {0!r}", name={0!r})\n'.format(name))
    return {'PYTHONPATH': folder + ':' + os.environ.get('PYTHONPATH', '')}


def random_namespace():
    return '/test_' + uuid.uuid4().hex


def poll_until(condition, what):
    deadline = time.monotonic() + TIMEOUT
    while not condition():
        if time.monotonic() > deadline:
            raise AssertionError('no {} within {} s'.format(what, TIMEOUT))
        time.sleep(0.02)


def bits(message):
    """The message as it goes over the wire: equal for equal bits, NaN included."""
    buffer = BytesIO()
    message.serialize(buffer)
    return buffer.getvalue()


def run_tool(name, *arguments):
    return subprocess.run([program(name), *arguments], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, universal_newlines=True, timeout=TIMEOUT)


def impact(scene, values):
    """What the impact tool finds in this scene."""
    assignments = ['{}={}'.format(key, value) for key, value in values.items()]
    run = run_tool('impact', scene_file(scene), *assignments)
    if run.returncode != 0:
        raise AssertionError('impact failed: ' + run.stderr)
    return yaml.safe_load(run.stdout)


class BagAnalysis:
    """What analyse_bag says of the one namespace that the bag holds."""

    def __init__(self, bag, *options):
        run = run_tool('analyse_bag', bag, *options)
        self.exit_code = run.returncode
        self.problems = run.stderr
        document = yaml.safe_load(run.stdout) or {}
        self.namespace, content = next(iter(document.items()), (None, {}))
        self.topics = content.get('topics', {})
        self.runs = content.get('runs', [])
        self.law_fits = content.get('law_fits', [])


def bag_messages(bag, topic):
    with rosbag.Bag(bag) as content:
        return [message for _, message, _ in content.read_messages(topics=[topic])]


class Process:
    """A program in the background, whose output goes to files. Ends with the `with` block."""

    def __init__(self, command, environment=None, before_start=None):
        self._stdout = tempfile.TemporaryFile()
        self._stderr = tempfile.TemporaryFile()
        self._process = subprocess.Popen(command, stdout=self._stdout, stderr=self._stderr,
                                         env=dict(os.environ, **(environment or {})),
                                         restore_signals=before_start is None,
                                         preexec_fn=before_start)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self._process.poll() is None:
            self.send(signal.SIGTERM)
            try:
                self.wait()
            except AssertionError:
                self._process.kill()
                self._process.wait()
        self._stdout.close()
        self._stderr.close()

    def wait(self):
        """The exit code."""
        try:
            return self._process.wait(TIMEOUT)
        except subprocess.TimeoutExpired:
            raise AssertionError('{} still runs after {} s: {}'.format(
                self._process.args[0], TIMEOUT, self.stdout() + self.stderr()))

    def send(self, signal_number):
        self._process.send_signal(signal_number)

    def is_running(self):
        return self._process.poll() is None

    def stdout(self):
        return self._text(self._stdout)

    def stderr(self):
        return self._text(self._stderr)

    @staticmethod
    def _text(file):
        file.seek(0)
        return file.read().decode()


@contextlib.contextmanager
def limited_to(size, kind):
    """Nodes of this kind that start meanwhile cannot write files larger than `size` bytes."""
    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
    _limits[kind] = limit
    try:
        yield
    finally:
        del _limits[kind]


_limits = {}


def node(kind, name, parameters, environment=None):
    """A node in the background, with these private parameters. Its name is absolute."""
    namespace, base = name.rsplit('/', 1)
    if parameters:
        rospy.set_param(name, parameters)
    return Process([program(kind), '__ns:=' + namespace, '__name:=' + base], environment,
                   _limits.get(kind))


def simulation(namespace, scene, values, environment=None, **parameters):
    """The simulation node in the background; `parameters` beside those of the scene."""
    tree = dict(scene_parameters(scene, values), timeout=NODE_TIMEOUT)
    tree.update(parameters)
    return node('simulation_node', namespace + '/simulation', tree, environment)


def analysis(namespace, environment=None, **parameters):
    return node('analysis_node', namespace + '/analysis',
                dict({'timeout': NODE_TIMEOUT}, **parameters), environment)


def recorder(namespace, environment=None, **parameters):
    return node('recorder_node', namespace + '/recorder',
                dict({'timeout': NODE_TIMEOUT}, **parameters), environment)


def replay(namespace, bag, environment=None, **parameters):
    """Of what was recorded in this namespace."""
    return node('replay_node', namespace + '/player',
                dict({'timeout': NODE_TIMEOUT, 'bag': bag, 'ns': namespace}, **parameters),
                environment)


def viewer(namespace, environment=None):
    return node('viewer_node', namespace + '/viewer', {}, environment)


def launch(file, environment=None, **arguments):
    assignments = ['{}:={}'.format(name, value) for name, value in arguments.items()]
    return Process(['roslaunch', PACKAGE, file, *assignments], environment)


class Inbox:
    """All messages of a topic from now on."""

    def __init__(self, topic, message_type):
        self._topic = topic
        self._messages = []
        self._news = threading.Condition()
        self._subscriber = rospy.Subscriber(topic, message_type, self._take_in, queue_size=None)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._subscriber.unregister()

    def messages(self):
        with self._news:
            return list(self._messages)

    def wait(self, condition, what, timeout=TIMEOUT):
        """The first message, come or to come, for which the condition holds."""
        with self._news:
            if not self._news.wait_for(lambda: any(map(condition, self._messages)), timeout):
                raise AssertionError('{}: no message {} within {} s, but {} others'.format(
                    self._topic, what, timeout, len(self._messages)))
            return next(filter(condition, self._messages))

    def wait_for_count(self, count, timeout=TIMEOUT):
        """However long it takes, as long as messages come."""
        with self._news:
            while len(self._messages) < count:
                if not self._news.wait(timeout):
                    raise AssertionError('{}: {} messages of {}, and no more for {} s'.format(
                        self._topic, len(self._messages), count, timeout))

    def _take_in(self, message):
        with self._news:
            self._messages.append(message)
            self._news.notify_all()
