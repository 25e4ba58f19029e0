#!/usr/bin/python3
"""Bags hold all that was published, and give the numbers of the live run, bit for bit."""

import os
import tempfile
import unittest
import xmlrpc.client

import rosbag
import rosgraph
import rospy
import rostest

from programs import (IMPACT_RESULTS, PACKAGE, TIMEOUT, BagAnalysis, bag_messages, bits, impact,
                      launch, poll_until, random_namespace, recorder)
from results import Results

SERIES = {'N': 60, 'eta': 10, 'velocity': [0.01, 0.02, 0.03, 0.05, 0.08], 'period': 0.1}
SCENE = {'disk.points': 1000, 'impact.velocity': 0.015}
RECORDED = {'lattice', 'particle_states', 'contact_forces', 'run_status', 'scalars', 'strain',
            'restitution', 'law_fit'}


class RecordingTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.namespace = random_namespace()
        cls.bag = os.path.join(cls.folder.name, 'collision.bag')
        with launch('collision.launch', ns=cls.namespace, bag=cls.bag,
                    N=SCENE['disk.points'],
                    velocity=SCENE['impact.velocity']) as run:
            run.wait()
            cls.output = run.stdout()
            cls.errors = run.stderr()
        cls.strain = bag_messages(cls.bag, cls.namespace + '/strain')
        cls.restitution = bag_messages(cls.bag, cls.namespace + '/restitution')
        cls.law_fit = bag_messages(cls.bag, cls.namespace + '/law_fit')

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_recorder_loses_nothing(self):
        analysis = BagAnalysis(self.bag)
        self.assertEqual(analysis.exit_code, 0, analysis.problems)
        self.assertEqual(set(analysis.topics), {self.namespace + '/' + name for name in RECORDED})
        for topic, counts in analysis.topics.items():
            self.assertGreater(counts['recorded'], 0, topic)
            self.assertEqual(counts['recorded'], counts['published'], topic)
            self.assertEqual(counts['recorded'], len(bag_messages(self.bag, topic)), topic)

    def test_recorder_reports_when_it_ends(self):
        self.assertIn('recorded 1 run(s) in ' + self.bag, self.output)

    def test_launch_ends_without_an_alarm(self):
        self.assertNotIn('REQUIRED', self.output + self.errors)
        self.assertNotIn('\x1b[31m', self.output + self.errors)  # red

    def test_refused_run_does_not_show_an_earlier_one(self):
        with launch('collision.launch', ns=self.namespace, bag=self.bag, N='ten') as run:
            run.wait()
            self.assertNotIn('restitution:', run.stdout())
        self.assertEqual(BagAnalysis(self.bag).exit_code, 0)

    def test_recorder_of_nothing_keeps_an_earlier_bag(self):
        with open(self.bag, 'rb') as file:
            earlier = file.read()
        files = os.listdir(self.folder.name)
        idle = random_namespace()
        name = idle + '/recorder'
        with recorder(idle, bag=self.bag) as recording:
            subscribers = lambda: dict(rosgraph.Master(name).getSystemState()[1])
            poll_until(lambda: name in subscribers().get(idle + '/run_status', []), name)
            address = rosgraph.Master(name).lookupNode(name)
            xmlrpc.client.ServerProxy(address).shutdown(name, 'end of the test')
            self.assertEqual(recording.wait(), 1)
            self.assertIn('nothing was recorded', recording.stderr())
        with open(self.bag, 'rb') as file:
            self.assertEqual(file.read(), earlier)
        self.assertEqual(os.listdir(self.folder.name), files)

    def test_scenes_follow_each_other_on_one_master(self):
        bag = os.path.join(self.folder.name, 'contact.bag')
        with launch('contact.launch', ns=self.namespace, bag=bag, N=60) as run:
            run.wait()
        run, = BagAnalysis(bag).runs
        self.assertEqual(run['strain'], impact('contact', {'disk.points': 60})['strain'])

    def test_bag_gives_the_numbers_of_the_tool(self):
        run, = BagAnalysis(self.bag).runs
        self.assertTrue(run['complete'])
        self.assertEqual(run['flags'], [])
        expected = impact('collision', SCENE)
        for key in IMPACT_RESULTS:
            self.assertEqual(run[key], expected[key], key)

    def test_bag_gives_the_numbers_of_the_live_run(self):
        live = self.restitution[-1]
        self.assertTrue(live.ended and live.complete)
        run, = BagAnalysis(self.bag).runs
        for key in IMPACT_RESULTS:
            self.assertEqual(run[key], getattr(live, key), key)
        self.assertEqual(run['velocity'], -live.velocity_before)

    def replay(self, bag, counts, rate):
        """The messages of each of the topics, as many of them as said."""
        with Results(self.namespace) as results:
            inboxes = [getattr(results, topic) for topic in counts]
            # On a busy machine this reader, in Python, may lag many seconds behind.
            with launch('replay.launch', ns=self.namespace, bag=bag, rate=rate, linger=TIMEOUT,
                        wait_for='[{}]'.format(rospy.get_name())):
                for inbox, count in zip(inboxes, counts.values()):
                    inbox.wait_for_count(count)
            return [inbox.messages() for inbox in inboxes]

    def assert_replay_equals_live(self, rate):
        live = {topic: getattr(self, topic) for topic in ('strain', 'restitution', 'law_fit')}
        self.assertGreater(len(live['strain']), 100)
        replayed = self.replay(self.bag, {topic: len(live[topic]) for topic in live}, rate)
        for topic, messages in zip(live, replayed):
            self.assertEqual(list(map(bits, messages)), list(map(bits, live[topic])), topic)

    def test_replay_equals_live_run(self):
        self.assert_replay_equals_live(rate=1)

    def test_replay_as_fast_as_it_goes_equals_live_run(self):
        self.assert_replay_equals_live(rate=1e6)

    def test_fits_of_a_series_are_the_same_live_replayed_and_from_the_bag(self):
        bag = os.path.join(self.folder.name, 'series.bag')
        with launch('collision.launch', ns=self.namespace, bag=bag, **SERIES) as run:
            run.wait()
        live = bag_messages(bag, self.namespace + '/law_fit')
        self.assertEqual([len(law.x) for law in live], [1, 2, 3, 4, 5])
        self.assertEqual(live[0].declined, 'fewer than four points')
        self.assertEqual(live[-1].declined, '')
        self.assertEqual(live[-1].names, ['d1', 'd2'])
        self.assertGreater(live[-1].values[1], 2 * live[-1].standard_errors[1])

        analysis = BagAnalysis(bag)
        self.assertEqual(analysis.exit_code, 0, analysis.problems)
        law, = analysis.law_fits
        self.assertEqual(law['y'], [run['restitution'] for run in analysis.runs])
        for key in ('run', 'x', 'y', 'y_theory', 'values', 'standard_errors', 'residual',
                    'dissipation_time', 'sound_speed'):
            found = getattr(live[-1], key)
            self.assertEqual(law[key], list(found) if isinstance(found, tuple) else found, key)

        replayed, = self.replay(bag, {'law_fit': len(live)}, rate=10)
        self.assertEqual(list(map(bits, replayed)), list(map(bits, live)))

    def test_replay_of_a_bag_without_a_topic_of_a_run_keeps_the_other_runs(self):
        bag = os.path.join(self.folder.name, 'whole.bag')
        with launch('collision.launch', ns=self.namespace, bag=bag, N=60,
                    velocity=[0.02, 0.05]) as run:
            run.wait()
        live = bag_messages(bag, self.namespace + '/restitution')[-1]
        damaged = os.path.join(self.folder.name, 'damaged.bag')
        with rosbag.Bag(bag) as whole, rosbag.Bag(damaged, 'w') as copy:
            for topic, message, stamp in whole.read_messages():
                if not (topic.endswith('/contact_forces') and message.run == 0):
                    copy.write(topic, message, stamp)
        with Results(self.namespace) as results, \
                launch('replay.launch', ns=self.namespace, bag=damaged, rate=1e6, linger=TIMEOUT,
                       wait_for='[{}]'.format(rospy.get_name())):
            replayed = results.final_restitution(1)
            replayed.header.seq = live.header.seq  # counts the messages of both runs
            self.assertEqual(bits(replayed), bits(live))
            self.assertFalse(results.final_restitution(0).complete)

    def test_constants_can_be_given(self):
        bag = os.path.join(self.folder.name, 'constants.bag')
        with launch('collision.launch', ns=self.namespace, bag=bag, N=60, period=0.1,
                    velocity=[0.02, 0.05], young_modulus=1.2, poisson_ratio=0.3) as run:
            run.wait()
        law = bag_messages(bag, self.namespace + '/law_fit')[-1]
        self.assertEqual((law.young_modulus, law.poisson_ratio), (1.2, 0.3))
        given, = BagAnalysis(bag, '--young-modulus=1.2', '--poisson-ratio=0.3').law_fits
        self.assertEqual(given['x'], list(law.x))


if __name__ == '__main__':
    rospy.init_node('recording')
    rostest.rosrun(PACKAGE, 'recording', RecordingTest)
