#!/usr/bin/python3
"""Records test/fuzz/recorded.bag anew, as is needed when a message has changed.

Two impacts and two contacts with a few states each, by both nodes and the recorder. The definitions
of the messages are left out: they would be most of it.
"""

import pathlib
import subprocess
import tempfile

import rosbag
import yaml

HERE = pathlib.Path(__file__).resolve().parent
SCENES = {
    'collision': {'scene': 'collision', 'disk': {'points': 3}, 'impact': {'velocity': [0.05, 0.1]},
                  'output': {'period': 3.0}},
    'contact': {'scene': 'contact', 'disk': {'points': 3}, 'material': {'eta': 20.0},
                'load': {'P': [0.01, 0.02]}, 'output': {'period': 40.0}}}


def record(name, folder):
    scene, bag = folder / 'scene.yaml', folder / (name + '.bag')
    scene.write_text(yaml.safe_dump(SCENES[name]))
    subprocess.run(['roslaunch', 'lattice_impact', name + '.launch', 'ns:=' + name,
                    'scene:={}'.format(scene), 'bag:={}'.format(bag)], check=True)
    return bag


def copy(bag, to):
    for topic, (kind, content, md5sum, *rest), stamp in bag.read_messages(raw=True):
        header = {'topic': topic, 'type': kind, 'md5sum': md5sum, 'message_definition': ''}
        to.write(topic, (kind, content, md5sum, *rest), stamp, raw=True, connection_header=header)


def main():
    with tempfile.TemporaryDirectory() as folder, \
            rosbag.Bag(str(HERE / 'recorded.bag'), 'w', compression='bz2') as recorded:
        for name in SCENES:
            with rosbag.Bag(str(record(name, pathlib.Path(folder)))) as bag:
                copy(bag, recorded)


if __name__ == '__main__':
    main()
