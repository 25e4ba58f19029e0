#!/usr/bin/python3
"""Bags hold all that was published, and give the numbers of the live run, bit for bit."""

import os
import tempfile
import unittest

import rospy
import rostest

from programs import (IMPACT_RESULTS, PACKAGE, BagAnalysis, bag_messages, bits, impact, launch,
                      random_namespace)
from results import Results

SCENE = {'disk.points': 1000, 'impact.velocity': 0.015}
RECORDED = {'lattice', 'particle_states', 'contact_forces', 'run_status', 'strain', 'restitution'}


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
        cls.strain = bag_messages(cls.bag, cls.namespace + '/strain')
        cls.restitution = bag_messages(cls.bag, cls.namespace + '/restitution')

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
        self.assertIn(self.namespace + '/particle_states: {published: ', self.output)

    def test_refused_run_does_not_show_an_earlier_one(self):
        with launch('collision.launch', ns=self.namespace, bag=self.bag, N='ten') as run:
            run.wait()
            output = run.stdout()
        self.assertIn('nothing was recorded', output)
        self.assertNotIn('restitution:', output)
        self.assertEqual(BagAnalysis(self.bag).exit_code, 0)

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

    def replay(self, rate):
        with Results(self.namespace) as results:
            with launch('replay.launch', ns=self.namespace, bag=self.bag, rate=rate,
                        wait_for='[{}]'.format(rospy.get_name())) as run:
                run.wait()
            results.strain.wait_for_count(len(self.strain))
            results.restitution.wait_for_count(len(self.restitution))
            return results.strain.messages(), results.restitution.messages()

    def assert_replay_equals_live(self, rate):
        strain, restitution = self.replay(rate)
        self.assertGreater(len(strain), 100)
        self.assertEqual(list(map(bits, strain)), list(map(bits, self.strain)))
        self.assertEqual(list(map(bits, restitution)), list(map(bits, self.restitution)))

    def test_replay_equals_live_run(self):
        self.assert_replay_equals_live(rate=1)

    def test_tenfold_replay_equals_live_run(self):
        self.assert_replay_equals_live(rate=10)


if __name__ == '__main__':
    rospy.init_node('recording')
    rostest.rosrun(PACKAGE, 'recording', RecordingTest)
