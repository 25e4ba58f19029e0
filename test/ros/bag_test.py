#!/usr/bin/python3
"""Bags that the simulation node writes itself, and bags of runs that were interrupted."""

import json
import os
import random
import re
import signal
import tempfile
import unittest

import rosbag
import rospy
import rostest
from lattice_impact.msg import ParticleStates, RunStatus

from programs import (ENDLESS_COLLISION, IMPACT_RESULTS, PACKAGE, SMALL_ABSORBING_WALL,
                      SMALL_COLLISION, SMALL_CONTACT, SMALL_ROW, BagAnalysis, Inbox, bag_messages,
                      impact, launch, limited_to, random_namespace, recorder, run_tool,
                      simulation)


class BagTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.bag = os.path.join(self.folder, 'run.bag')
        self.incomplete = os.path.join(self.folder, 'run.incomplete.bag')
        self.namespace = random_namespace()

    def simulate(self, scene, values):
        with simulation(self.namespace, scene, values, bag=self.bag) as node:
            self.assertEqual(node.wait(), 0, node.stderr())
        return self.complete_analysis()

    def complete_analysis(self):
        analysis = BagAnalysis(self.bag)
        self.assertEqual(analysis.exit_code, 0, analysis.problems)
        self.assertEqual(set(analysis.topics),
                         {self.namespace + '/' + name for name in
                          ('lattice', 'particle_states', 'contact_forces', 'run_status', 'scalars')})
        for topic, counts in analysis.topics.items():
            self.assertEqual(counts['recorded'], counts['published'], topic)
        return analysis

    def test_collision_without_subscribers(self):
        run, = self.simulate('collision', SMALL_COLLISION).runs
        self.assertTrue(run['complete'])
        expected = impact('collision', SMALL_COLLISION)
        for key in IMPACT_RESULTS:
            self.assertEqual(run[key], expected[key], key)

    def test_text_and_json_of_a_bag(self):
        """The same numbers, with the digits that their errors allow."""
        result, = self.simulate('collision', SMALL_COLLISION).runs
        text = run_tool('analyse_bag', self.bag, '--text').stdout
        found = re.search(r'\n  restitution e +(\S+) +± (\S+)\n', text)
        self.assertAlmostEqual(float(found[1]), result['restitution'],
                               delta=0.5 * result['restitution_error'])  # by rounding
        self.assertAlmostEqual(float(found[2]), result['restitution_error'],
                               delta=0.05 * result['restitution_error'])  # two digits
        self.assertIn('messages on 5 topics, all that were published\n  bag ' + self.bag, text)
        self.assertNotIn('fit:', text)  # one point shows no law
        document = json.loads(run_tool('analyse_bag', self.bag, '--json').stdout)
        self.assertEqual(document[self.namespace]['runs'], [result])

    def test_contact_without_subscribers(self):
        run, = self.simulate('contact', SMALL_CONTACT).runs
        expected = impact('contact', SMALL_CONTACT)
        for key in ('strain', 'strain_from_radius', 'rotation', 'wall_force'):
            self.assertEqual(run[key], expected[key], key)

    def test_elastic_wall(self):
        """Both bodies state by state; the forces on one are the reactions to those on the other."""
        with simulation(self.namespace, 'absorbing_wall', SMALL_ABSORBING_WALL,
                        bag=self.bag) as node:
            self.assertEqual(node.wait(), 0, node.stderr())
        wall, = bag_messages(self.bag, self.namespace + '/wall/lattice')
        self.assertEqual((wall.name, len(wall.x)), ('wall', 140))
        self.assertEqual(max(wall.y), 0.0)
        states = bag_messages(self.bag, self.namespace + '/particle_states')
        wall_states = bag_messages(self.bag, self.namespace + '/wall/particle_states')
        self.assertEqual([(s.sequence, s.step, len(s.x)) for s in wall_states],
                         [(s.sequence, s.step, 140) for s in states])
        pushed = 0
        for on_disk, on_wall in zip(
                bag_messages(self.bag, self.namespace + '/contact_forces'),
                bag_messages(self.bag, self.namespace + '/wall/contact_forces')):
            self.assertEqual((on_wall.total_x, on_wall.total_y),
                             (-on_disk.total_x, -on_disk.total_y))
            # What is left out is below 1e-6 velocity each; forces are up to 0.1.
            self.assertAlmostEqual(sum(on_wall.fy), on_wall.total_y, delta=1e-5)
            pushed += len(on_wall.point)
        self.assertGreater(pushed, 0)
        result = impact('absorbing_wall', SMALL_ABSORBING_WALL)
        run, = BagAnalysis(self.bag).runs
        self.assertEqual(run['restitution'], result['restitution'])

    def test_row_of_disks(self):
        """Every body has topics of its own, and what one feels others feel the other way."""
        with simulation(self.namespace, 'row_of_disks', SMALL_ROW, bag=self.bag) as node:
            self.assertEqual(node.wait(), 0, node.stderr())
        analysis = BagAnalysis(self.bag)
        self.assertEqual(analysis.exit_code, 0, analysis.problems)
        prefixes = [self.namespace + body for body in ('/', '/wall/', '/wall2/', '/wall3/')]
        self.assertEqual(set(analysis.topics),
                         {self.namespace + '/' + name for name in ('run_status', 'scalars')} |
                         {prefix + name for prefix in prefixes
                          for name in ('lattice', 'particle_states', 'contact_forces')})
        names = [bag_messages(self.bag, prefix + 'lattice')[0].name for prefix in prefixes]
        self.assertEqual(names, ['disk', 'wall', 'wall2', 'wall3'])
        pushed = [0, 0, 0, 0]
        for forces in zip(*(bag_messages(self.bag, prefix + 'contact_forces')
                            for prefix in prefixes)):
            self.assertEqual(len({on_body.sequence for on_body in forces}), 1)
            self.assertAlmostEqual(sum(on_body.total_y for on_body in forces), 0.0, delta=1e-12)
            pushed = [sum_ + len(on_body.point) for sum_, on_body in zip(pushed, forces)]
        self.assertGreater(min(pushed), 0)
        run, = analysis.runs
        self.assertTrue(run['complete'])
        expected = impact('row_of_disks', SMALL_ROW)
        of_row = ('momentum_passed_on', 'restitution_of_ends', 'wall_velocity_after',
                  'wall2_tangential_velocity_after', 'wall3_spin_after')
        for key in IMPACT_RESULTS + of_row:
            self.assertEqual(run[key], expected[key], key)
            self.assertEqual(run[key + '_error'], expected[key + '_error'], key)

    def interrupt_node(self, signal_number):
        with simulation(self.namespace, 'collision', ENDLESS_COLLISION, bag=self.bag,
                        max_rate=200.0) as node:
            self.wait_for_state(20)
            node.send(signal_number)
            self.assertEqual(node.wait(), 1)
            self.assertIn('kept as ' + self.incomplete, node.stderr())

    def wait_for_state(self, sequence):
        with Inbox(self.namespace + '/particle_states', ParticleStates) as states:
            states.wait(lambda message: message.sequence >= sequence, 'of mid-run')

    def assert_closed_but_incomplete(self):
        self.assertEqual(os.listdir(self.folder), [os.path.basename(self.incomplete)])
        analysis = BagAnalysis(self.incomplete)
        self.assertEqual(analysis.exit_code, 1)
        self.assertIn(self.incomplete + ' is not complete', analysis.problems)
        self.assertIn('run 0: interrupted', analysis.problems)
        run, = analysis.runs
        self.assertFalse(run['complete'])
        self.assertGreater(analysis.topics[self.namespace + '/particle_states']['recorded'], 20)

    def assert_end_is_announced(self):
        status = bag_messages(self.incomplete, self.namespace + '/run_status')[-1]
        self.assertEqual(status.phase, RunStatus.INTERRUPTED)
        self.assertEqual(len(bag_messages(self.incomplete, self.namespace + '/particle_states')),
                         status.states)

    def test_sigint_closes_the_bag_of_the_node(self):
        self.interrupt_node(signal.SIGINT)
        self.assert_end_is_announced()
        self.assert_closed_but_incomplete()

    def test_sigterm_closes_the_bag_of_the_node(self):
        self.interrupt_node(signal.SIGTERM)
        self.assert_end_is_announced()
        self.assert_closed_but_incomplete()

    def test_sigint_closes_the_bag_of_the_recorder(self):
        with launch('collision.launch', ns=self.namespace, bag=self.bag, max_rate=200,
                    N=ENDLESS_COLLISION['disk.points'],
                    velocity=ENDLESS_COLLISION['impact.velocity']) as run:
            self.wait_for_state(20)
            run.send(signal.SIGINT)
            run.wait()
        self.assert_closed_but_incomplete()

    def test_damaged_bag_gives_no_other_number(self):
        """Bytes changed, taken away or cut: it is told, in words, or it did no harm."""
        self.simulate('collision', {'disk.points': 30, 'impact.velocity': 0.05, 'output.period': 0.5})
        whole = run_tool('analyse_bag', self.bag).stdout
        with open(self.bag, 'rb') as file:
            content = file.read()
        seed = random.randrange(2 ** 32)
        draw = random.Random(seed)
        for number in range(60):
            damaged = bytearray(content)
            place = draw.randrange(len(damaged))
            if number % 3 == 0:
                damaged[place] ^= 1 << draw.randrange(8)
            elif number % 3 == 1:
                del damaged[place:place + draw.randrange(1, 200)]
            else:
                del damaged[place:]
            with open(self.bag, 'wb') as file:
                file.write(damaged)
            run = run_tool('analyse_bag', self.bag)
            what = 'seed {}, number {}: {}'.format(seed, number, run.stderr)
            self.assertIn(run.returncode, (0, 1, 2), what)
            if run.returncode == 0:
                self.assertEqual(run.stdout, whole, what)
            else:
                self.assertTrue(run.stderr.startswith('analyse_bag: '), what)

    def test_bag_of_another_version_is_refused(self):
        """As one in which a message has other fields, and so another sum of its definition."""
        self.simulate('collision', SMALL_COLLISION)
        other = os.path.join(self.folder, 'other.bag')
        with rosbag.Bag(self.bag) as bag, rosbag.Bag(other, 'w') as copy:
            for topic, (kind, content, md5sum, *rest), stamp in bag.read_messages(raw=True):
                if kind == 'lattice_impact/RunStatus':
                    md5sum = '0' * 32
                header = {'topic': topic, 'type': kind, 'md5sum': md5sum, 'message_definition': ''}
                copy.write(topic, (kind, content, md5sum, *rest), stamp, raw=True,
                           connection_header=header)
        done = run_tool('analyse_bag', other)
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, '^analyse_bag: .*other.bag was recorded by another version of '
                                      'lattice_impact, in which lattice_impact/RunStatus .*\n$')

    def test_status_on_another_topic_is_told(self):
        self.simulate('collision', {'disk.points': 30, 'impact.velocity': 0.05, 'output.period': 0.5})
        with rosbag.Bag(self.bag) as bag:
            records = list(bag.read_messages())
        with rosbag.Bag(self.bag, 'w') as bag:
            for topic, message, stamp in records:
                is_first = topic.endswith('/run_status') and message.phase == RunStatus.RUNNING
                bag.write(self.namespace + '/status' if is_first else topic, message, stamp)
        analysis = BagAnalysis(self.bag)
        self.assertEqual(analysis.exit_code, 1)
        self.assertIn('run 0: run_status: 1 of 2 messages published', analysis.problems)

    def test_recording_ends_when_the_simulation_is_killed(self):
        with recorder(self.namespace, bag=self.bag, patience=0.5) as recording:
            with simulation(self.namespace, 'collision', ENDLESS_COLLISION, max_rate=200.0,
                            wait_for=['recorder'], acknowledged_by=['recorder']) as node:
                self.wait_for_state(20)
                node.send(signal.SIGKILL)
                self.assertEqual(recording.wait(), 1)
                self.assertIn('its end was not announced', recording.stderr())
                self.assertIn('kept as ' + self.incomplete, recording.stderr())
        self.assertEqual(os.listdir(self.folder), [os.path.basename(self.incomplete)])

    def test_simulation_ends_when_the_recorder_is_killed(self):
        """What the recorder leaves is named by the next one, and can be mended."""
        with recorder(self.namespace, bag=self.bag) as recording:
            with simulation(self.namespace, 'collision', ENDLESS_COLLISION, max_rate=200.0,
                            wait_for=['recorder'], acknowledged_by=['recorder']) as node:
                self.wait_for_state(20)
                recording.send(signal.SIGKILL)
                self.assertEqual(node.wait(), 1)
                self.assertIn('simulation_node: gone in mid-run: {}/recorder to '.format(
                    self.namespace), node.stderr())
        left = self.bag + '.active'
        self.assertEqual(os.listdir(self.folder), [os.path.basename(left)])
        with recorder(self.namespace, bag=self.bag, timeout=0.5) as recording:
            self.assertEqual(recording.wait(), 1)
            self.assertIn('`rosbag reindex {}`'.format(left), recording.stderr())
            self.assertIn('no message for 0.5 s', recording.stderr())
        self.assertEqual(os.listdir(self.folder), [os.path.basename(left)])

    def test_full_disk_ends_in_one_line(self):
        """A limit on the size of files stands for a full disk."""
        with open(self.bag, 'wb') as file:
            file.write(b'good')
        for kind in ('simulation_node', 'recorder_node'):
            with limited_to(2000000, kind), recorder(self.namespace, bag=self.bag) as recording:
                own = {} if kind == 'recorder_node' else {'bag': self.bag}
                with simulation(self.namespace, 'collision', SMALL_COLLISION,
                                wait_for=['recorder'], acknowledged_by=['recorder'],
                                **own) as node:
                    self.assertEqual(node.wait(), 1)
                    failing = recording if kind == 'recorder_node' else node
                    self.assertEqual(failing.wait(), 1)
                    self.assertRegex(failing.stderr(), kind + ': .* cannot be written: .*File too large')
                    self.assertNotIn('terminate', failing.stderr())
        with open(self.bag, 'rb') as file:
            self.assertEqual(file.read(), b'good')


if __name__ == '__main__':
    rospy.init_node('bag')
    rostest.rosrun(PACKAGE, 'bag', BagTest)
