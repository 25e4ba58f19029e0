"""Executed by roslaunch while it loads a launch file of this folder, before it starts anything: where
an argument is wrong, roslaunch ends with one line and exit code 2.

`launch_file` is the path of that file, `argument(name)` the value of one of its arguments.
"""

import difflib
import os
import re
import subprocess
import sys
from xml.etree import ElementTree

import yaml
from roslib.packages import find_node
from rospkg import RosPack


def refuse(line):
    print('{}: {}'.format(os.path.basename(launch_file), line), file=sys.stderr)
    sys.exit(2)


def declared_arguments():
    tags = ElementTree.parse(launch_file).getroot().findall('arg')
    return [tag.get('name') for tag in tags if tag.get('value') is None]


def check_names(declared):
    """roslaunch itself takes what the file does not declare, or an empty value, for nothing."""
    if not any(os.path.basename(word) == os.path.basename(launch_file) for word in sys.argv):
        return  # included by another file
    for word in sys.argv[1:]:
        name = re.match('([A-Za-z]\\w*):=', word)
        if name and name[1] not in declared:
            near = difflib.get_close_matches(name[1], declared, 1)
            refuse('{}: unknown argument{}, allowed: {}'.format(
                name[1], ' (did you mean {}?)'.format(near[0]) if near else '',
                ', '.join(declared)))
        if word == 'bag:=':
            refuse_no_bag()


def refuse_no_bag():
    refuse('bag: got nothing, allowed: a file')


def path_of_bag():
    bag = str(argument('bag'))
    if not bag:
        refuse_no_bag()
    return os.path.join(os.environ['PWD'], bag)


def check_flag(name):
    if argument(name) not in (True, False):
        refuse('{}: got {}, allowed: true or false'.format(name, argument(name)))


def check_rviz():
    check_flag('rviz')
    if not argument('rviz'):
        return
    if 'rviz' not in packages.list():
        refuse('rviz: not installed; Debian has it in the package rviz')
    if not find_node('lattice_impact', 'viewer_node', packages):
        refuse('rviz: viewer_node is not built; install {} and build again'.format(
            'libdiagnostic-updater-dev libtf2-msgs-dev libvisualization-msgs-dev'))
    if not os.environ.get('DISPLAY'):
        refuse('rviz: there is no display to show it on (DISPLAY is not set)')


def check_recording():
    check_flag('record')
    if not argument('record'):
        return
    folder = os.path.dirname(path_of_bag())
    if not os.path.isdir(folder):
        refuse('bag: there is no folder {}'.format(folder))
    if not os.access(folder, os.W_OK | os.X_OK):
        refuse('bag: {} cannot be written into'.format(folder))


def check_by(program, *values):
    """Started; its end is to be awaited by await_checks()."""
    found = find_node('lattice_impact', program, packages)
    if not found:
        refuse('{} is not built: cmake --build build'.format(program))
    return subprocess.Popen([found[0], '--check', *values],
                            stderr=subprocess.PIPE, universal_newlines=True)


def await_checks(*checks):
    for check in checks:
        problem = check.communicate()[1]
        if check.returncode != 0:
            refuse(problem.strip().partition(': ')[2])


def check_scene():
    return check_by('impact', str(argument('scene')), *yaml.safe_load(argument('assignments')))


def check_parameters(node, *names):
    return check_by(node, *('{}={}'.format(name, argument(name)) for name in names))


def check_replay():
    return check_by('replay_node', 'bag={}'.format(path_of_bag()),
                    *('{0}={1}'.format(name, argument(name)) for name in ('ns', 'rate')))


def is_about_to_run():
    only_show = ('--ros-args', '--nodes', '--files', '--args', '--find-node', '--dump-params')
    return (os.path.basename(sys.argv[0]) == 'roslaunch'
            and not any(word.startswith(only_show) for word in sys.argv))


if is_about_to_run():
    arguments = declared_arguments()
    packages = RosPack()
    check_names(arguments)
    check_rviz()
    if 'scene' in arguments:
        await_checks(
            check_scene(),
            check_parameters('simulation_node', 'max_rate', 'timeout', 'publish_clock'),
            check_parameters('analysis_node', 'young_modulus', 'poisson_ratio', 'timeout'))
        check_recording()
    else:
        await_checks(check_parameters('analysis_node', 'young_modulus', 'poisson_ratio', 'linger',
                                      'wait_for'),
                     check_replay())
