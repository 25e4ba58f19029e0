#!/usr/bin/python3
"""Puts the faults of list.yaml into the sources, one at a time, and runs the unit tests on each.

Prints which test noticed each fault, and at the end who survived. Ends with 1 if a fault survives
that is not explained as equivalent, if one does not compile, or if its line has changed.
"""

import argparse
import collections
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

import yaml

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent

Mutant = collections.namedtuple('Mutant', 'file text fault tests equivalent')


def read_list():
    """By file, in whose folder's test program a fault is looked for unless it names others."""
    mutants = []
    for file, faults in yaml.safe_load((HERE / 'list.yaml').read_text()).items():
        for fault in faults:
            mutants.append(Mutant(file, fault['text'], fault['fault'],
                                  fault.get('tests', [file.split('/')[1]]),
                                  fault.get('equivalent')))
    return mutants


def complaints(mutants):
    """Of entries that the sources have left behind."""
    for mutant in mutants:
        count = (ROOT / mutant.file).read_text().count(mutant.text)
        if count != 1:
            yield '{}: "{}" is there {} times'.format(mutant.file, mutant.text, count)


def tests_of(file):
    """Those in the file named after this one, as a filter; None: there is none."""
    room, name = file.split('/')[1:]
    path = ROOT / 'test' / room / (name.split('.')[0] + '_test.cpp')
    if not path.exists():
        return None
    suites = set(re.findall(r'^TEST(?:_F|_P)?\((\w+),', path.read_text(), re.MULTILINE))
    return ':'.join('{0}.*:*/{0}.*'.format(suite) for suite in sorted(suites))


def name_of(mutant):
    return re.sub(r'\s+', ' ', '{}: `{}` → `{}`'.format(mutant.file, mutant.text, mutant.fault))


class Checkout:
    """A copy of the files that git knows, built with one object a source."""

    def __init__(self, folder, jobs):
        self.source = folder / 'source'
        self.build = folder / 'build'
        self.jobs = jobs
        self.copy()

    def copy(self):
        """Files that are as they were keep their time, so that little is built again."""
        known = subprocess.check_output(['git', 'ls-files', '-z'], cwd=str(ROOT)).decode()
        names = set(filter(None, known.split('\0')))
        for source in self.source.glob('src/*/*'):
            if source.is_file() and str(source.relative_to(self.source)) not in names:
                source.unlink()
        for name in names:
            original, copied = ROOT / name, self.source / name
            if not copied.exists() or copied.read_bytes() != original.read_bytes():
                copied.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(str(original), str(copied))

    def configure(self):
        options = ['-DCATKIN_ENABLE_TESTING=ON', '-DCMAKE_UNITY_BUILD=OFF',
                   '-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG']
        if shutil.which('ccache'):
            options.append('-DCMAKE_CXX_COMPILER_LAUNCHER=ccache')
        if shutil.which('ninja'):
            options += ['-G', 'Ninja']
        subprocess.run(['cmake', '-S', str(self.source), '-B', str(self.build)] + options,
                       stdout=subprocess.DEVNULL, check=True)

    def builds(self, tests):
        """What the compiler says against it; None: nothing."""
        made = subprocess.run(['cmake', '--build', str(self.build), '-j', str(self.jobs), '--target']
                              + ['test_' + test for test in tests],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        return None if made.returncode == 0 else made.stdout.decode(errors='replace')

    def failure(self, test, timeout, which='*'):
        """The test that fails first; None: none does."""
        program = self.build / 'test' / ('test_' + test)
        try:
            ran = subprocess.run([str(program), '--gtest_brief=1', '--gtest_fail_fast',
                                  '--gtest_filter=' + which], stdout=subprocess.PIPE,
                                 stderr=subprocess.STDOUT, cwd=str(self.build), timeout=timeout)
        except subprocess.TimeoutExpired:
            return test + ': timeout'
        if ran.returncode == 0:
            return None
        found = re.search(r'\[  FAILED  \] ([^\s,]+)', ran.stdout.decode(errors='replace'))
        return found[1] if found else '{}: ends with {}'.format(test, ran.returncode)


def time_of(checkout, test):
    """Of the sources as they are, of which no test may fail."""
    began = time.monotonic()
    failure = checkout.failure(test, None)
    if failure:
        sys.exit('{} fails without a fault'.format(failure))
    return time.monotonic() - began


def try_out(checkout, mutant, times):
    """Who notices it, None if nobody does, and whether it compiles."""
    path = checkout.source / mutant.file
    original = path.read_text()
    path.write_text(original.replace(mutant.text, mutant.fault))
    try:
        complaint = checkout.builds(mutant.tests)
        if complaint:
            print(complaint, file=sys.stderr)
            return 'does not compile', False
        near = tests_of(mutant.file)
        tries = [(mutant.tests[0], near)] if near else []
        tries += [(test, '*') for test in mutant.tests]
        failures = (checkout.failure(test, 30.0 + 10.0 * times[test], which)
                    for test, which in tries)
        return next(filter(None, failures), None), True
    finally:
        path.write_text(original)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--only', default='', metavar='REGEX', help='of FILE: TEXT → FAULT')
    parser.add_argument('--list', action='store_true', help='build nothing, show the faults')
    parser.add_argument('--folder', type=pathlib.Path, default=ROOT / 'build' / 'mutants',
                        help='for the copy and what is built of it')
    parser.add_argument('--jobs', type=int, default=os.cpu_count())
    options = parser.parse_args()
    mutants = [mutant for mutant in read_list() if re.search(options.only, name_of(mutant))]
    outdated = list(complaints(mutants))
    if outdated:
        sys.exit('\n'.join(outdated))
    if options.list:
        print('\n'.join(map(name_of, mutants)))
        return
    checkout = Checkout(options.folder.resolve(), options.jobs)
    checkout.configure()
    tests = sorted({test for mutant in mutants for test in mutant.tests})
    complaint = checkout.builds(tests)
    if complaint:
        sys.exit(complaint)
    times = {test: time_of(checkout, test) for test in tests}
    sys.exit(1 if report(checkout, mutants, times) else 0)


def report(checkout, mutants, times):
    """What is wrong with the tests or with the list, after the table of all faults."""
    survivors, wrong = [], []
    print('| fault | noticed by |\n|---|---|')
    for mutant in mutants:
        noticed, compiles = try_out(checkout, mutant, times)
        print('| {} | {} |'.format(name_of(mutant).replace('|', '\\|'), noticed or '**survived**'),
              flush=True)
        if not noticed:
            survivors.append(mutant)
        if not compiles or bool(noticed) == bool(mutant.equivalent):
            wrong.append(mutant)
    print('\n{} of {} noticed.'.format(len(mutants) - len(survivors), len(mutants)))
    for mutant in survivors:
        print('- {}: {}'.format(name_of(mutant), mutant.equivalent or 'SURVIVED, unexplained'))
    return wrong


if __name__ == '__main__':
    main()
