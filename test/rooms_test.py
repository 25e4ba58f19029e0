#!/usr/bin/env python3
"""Each folder of src uses only those above it in the table of doc/extending.md."""
import os
import re
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
SIDE_BY_SIDE = {'nodes', 'tools'}
MOST_OF_ALL_LINES = 0.25


def folders_from_the_table():
    with open(os.path.join(ROOT, 'doc', 'extending.md'), encoding='utf-8') as page:
        return re.findall(r'^\| `src/(\w+)` \|', page.read(), re.MULTILINE)


def sources(folder):
    path = os.path.join(ROOT, 'src', folder)
    for name in sorted(os.listdir(path)):
        if name.endswith(('.cpp', '.hpp', '.inc')):
            with open(os.path.join(path, name), encoding='utf-8') as source:
                yield '{}/{}'.format(folder, name), source.read()


class Rooms(unittest.TestCase):

    def setUp(self):
        self.order = folders_from_the_table()

    def test_the_table_lists_every_folder(self):
        there = {name for name in os.listdir(os.path.join(ROOT, 'src'))
                 if os.path.isdir(os.path.join(ROOT, 'src', name))}
        self.assertEqual(sorted(self.order), sorted(there))

    def test_includes_point_upwards_in_the_table(self):
        wrong = []
        for place, folder in enumerate(self.order):
            allowed = set(self.order[:place + 1])
            if folder in SIDE_BY_SIDE:
                allowed -= SIDE_BY_SIDE - {folder}
            for name, text in sources(folder):
                for used in re.findall(r'^#include "(\w+)/', text, re.MULTILINE):
                    if used not in allowed:
                        wrong.append('{} includes {}'.format(name, used))
        self.assertEqual(wrong, [])

    def test_no_folder_holds_more_than_a_quarter(self):
        lines = {folder: sum(text.count('\n') for _, text in sources(folder))
                 for folder in self.order}
        most = max(lines, key=lines.get)
        self.assertLess(lines[most], MOST_OF_ALL_LINES * sum(lines.values()), most)


if __name__ == '__main__':
    unittest.main()
