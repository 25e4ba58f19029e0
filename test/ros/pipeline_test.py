#!/usr/bin/python3
"""The simulation and the analysis node together find what the impact tool finds, bit for bit."""

import contextlib
import os
import tempfile
import time
import unittest

import rospy
import rostest
from lattice_impact.msg import ContactForces, Lattice, ParticleStates, RunStatus

from master_witness import MasterWithLateLink
from programs import (IMPACT_RESULTS, PACKAGE, SMALL_COLLISION, SMALL_CONTACT, TIMEOUT, Inbox,
                      analysis, bag_messages, impact, poll_until, random_namespace, recorder,
                      simulation)
from results import Pipeline

DATA_TOPICS = {'lattice': Lattice, 'particle_states': ParticleStates,
               'contact_forces': ContactForces, 'run_status': RunStatus}


def final_restitution(scene, values, **parameters):
    with Pipeline(random_namespace(), scene, values, **parameters) as pipeline:
        pipeline.finish()
        return pipeline.results.final_restitution()


def wait_until_advertised(topic):
    poll_until(lambda: topic in dict(rospy.get_published_topics()), 'publisher of ' + topic)


class PipelineTest(unittest.TestCase):
    def assert_equals_tool(self, restitution, scene, values):
        self.assertTrue(restitution.ended)
        self.assertTrue(restitution.complete)
        self.assertEqual(restitution.flags, [])
        expected = impact(scene, values)
        for key in IMPACT_RESULTS:
            self.assertEqual(getattr(restitution, key), expected[key], key)

    def test_collision_equals_impact_tool(self):
        self.assert_equals_tool(final_restitution('collision', {}), 'collision', {})

    def test_contact_equals_impact_tool(self):
        with Pipeline(random_namespace(), 'contact', SMALL_CONTACT) as pipeline:
            pipeline.finish()
            strain = pipeline.results.strain_at_rest()
        expected = impact('contact', SMALL_CONTACT)
        for key in ('strain', 'strain_from_radius', 'rotation'):
            self.assertEqual(getattr(strain, key), expected[key], key)
        self.assertEqual(strain.force, expected['wall_force'])

    def test_results_do_not_depend_on_output_period(self):
        fine, coarse = (
            final_restitution('collision', dict(SMALL_COLLISION, **{'output.period': period}))
            for period in (0.02, 0.2))
        self.assertTrue(fine.complete and coarse.complete)
        for key in ('restitution', 'contact_duration', 'peak_force'):
            self.assertEqual(getattr(fine, key), getattr(coarse, key), key)

    def test_two_pipelines_run_side_by_side(self):
        scenes = {random_namespace(): dict(SMALL_COLLISION, **{'impact.velocity': velocity})
                  for velocity in (0.02, 0.05)}
        pipelines = {}
        inboxes = []
        try:
            for namespace, values in scenes.items():
                pipelines[namespace] = Pipeline(namespace, 'collision', values,
                                                wait_for=['analysis', rospy.get_name()])
            for namespace in scenes:
                wait_until_advertised(namespace + '/run_status')
            self.assertTrue(all(p.simulation.is_running() for p in pipelines.values()))
            inboxes = [Inbox(namespace + '/' + topic, kind)
                       for topic, kind in DATA_TOPICS.items() for namespace in scenes]
            found = {}
            for namespace, pipeline in pipelines.items():
                pipeline.finish()
                found[namespace] = pipeline.results.final_restitution()
        finally:
            for resource in [*pipelines.values(), *inboxes]:
                resource.__exit__()
        for namespace, values in scenes.items():
            self.assert_equals_tool(found[namespace], 'collision', values)
        self.assertEqual(len({message.restitution for message in found.values()}), 2)

    def test_acknowledgements_are_heard_late(self):
        namespace = random_namespace()
        acknowledged = namespace + '/acknowledged'
        with MasterWithLateLink(acknowledged) as master:
            with Pipeline(namespace, 'collision', SMALL_COLLISION, master.environment) as pipeline:
                master.wait_for_subscriber(acknowledged, TIMEOUT)
                wait_until_advertised(acknowledged)
                time.sleep(1.0)  # the lateness: time for the simulation to start and get stuck
                master.link()
                pipeline.finish()
                restitution = pipeline.results.final_restitution()
        self.assert_equals_tool(restitution, 'collision', SMALL_COLLISION)

    def test_nodes_whose_readers_have_everything_do_not_linger(self):
        namespace = random_namespace()
        forever = 10 * TIMEOUT
        with tempfile.TemporaryDirectory() as folder, \
                recorder(namespace, bag=os.path.join(folder, 'run.bag'),
                         results_of=['analysis']) as writer, \
                analysis(namespace, wait_for=['recorder'], exit_when_done=True,
                         linger=forever) as reader, \
                simulation(namespace, 'collision', SMALL_COLLISION,
                           wait_for=['analysis', 'recorder'], wait_for_scalars=['recorder'],
                           linger=forever,
                           acknowledged_by=['analysis', 'recorder']) as source:
            for process in (source, reader, writer):
                self.assertEqual(process.wait(), 0, process.stderr())

    def test_simulation_lingers_for_a_reader_that_acknowledges_nothing(self):
        namespace = random_namespace()
        with Inbox(namespace + '/run_status', RunStatus) as statuses, \
                Pipeline(namespace, 'collision', SMALL_COLLISION, linger=10 * TIMEOUT,
                         wait_for=['analysis', rospy.get_name()]) as pipeline, \
                contextlib.ExitStack() as inboxes:
            for topic, kind in DATA_TOPICS.items():
                inboxes.enter_context(Inbox(namespace + '/' + topic, kind))
            statuses.wait(lambda status: status.phase == RunStatus.FINISHED, 'of the end')
            time.sleep(1.0)  # it would have gone at once
            self.assertTrue(pipeline.simulation.is_running())

    def test_series_of_two_velocities(self):
        velocities = [0.01, 0.02]
        namespace = random_namespace()
        values = dict(SMALL_COLLISION, **{'impact.velocity': velocities})
        with tempfile.TemporaryDirectory() as folder:
            bag = os.path.join(folder, 'series.bag')
            with Pipeline(namespace, 'collision', values, bag=bag) as pipeline:
                pipeline.finish()
                found = [pipeline.results.final_restitution(run) for run in (0, 1)]
                results = pipeline.results.restitution.messages()
                law = pipeline.results.law_fit_of(run=1)
            states = bag_messages(bag, namespace + '/particle_states')
        self.assertEqual({message.run for message in results}, {0, 1})
        for velocity, restitution in zip(velocities, found):
            self.assert_equals_tool(restitution, 'collision',
                                    dict(SMALL_COLLISION, **{'impact.velocity': velocity}))
        self.assertEqual(list(law.y), [message.restitution for message in found])
        self.assertEqual(law.declined, 'fewer than four points')
        self.assert_series_is_contiguous(states, runs=2)

    def assert_series_is_contiguous(self, states, runs):
        states.sort(key=lambda message: (message.run, message.sequence))
        for run in range(runs):
            sequences = [message.sequence for message in states if message.run == run]
            self.assertGreater(len(sequences), 100)
            self.assertEqual(sequences, list(range(len(sequences))))
        stamps = [message.header.stamp for message in states]
        self.assertTrue(all(a < b for a, b in zip(stamps, stamps[1:])))


if __name__ == '__main__':
    rospy.init_node('pipeline')
    rostest.rosrun(PACKAGE, 'pipeline', PipelineTest)
