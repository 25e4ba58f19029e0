"""Hearing the results of an analysis node, and the pipeline of the two nodes."""

import rospy
from lattice_impact.msg import LawFit, Restitution, Strain

from programs import Inbox, analysis, simulation


class Results:
    """Hears the results of the analysis node of a namespace, from the first on when the node waits
    for this one."""

    def __init__(self, namespace):
        self.strain = Inbox(namespace + '/strain', Strain)
        self.restitution = Inbox(namespace + '/restitution', Restitution)
        self.law_fit = Inbox(namespace + '/law_fit', LawFit)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.strain.__exit__()
        self.restitution.__exit__()
        self.law_fit.__exit__()

    def final_restitution(self, run=0):
        return self.restitution.wait(lambda message: message.ended and message.run == run,
                                     'of the end of run {}'.format(run))

    def law_fit_of(self, run):
        return self.law_fit.wait(lambda message: message.run == run, 'of run {}'.format(run))

    def strain_at_rest(self):
        return self.strain.wait(lambda message: message.at_rest, 'at rest')


class Pipeline:
    """The simulation node, paced by the analysis node, which ends with the series."""

    def __init__(self, namespace, scene, values, environment=None, **simulation_parameters):
        self.results = Results(namespace)
        self.analysis = analysis(namespace, wait_for=[rospy.get_name()], exit_when_done=True)
        parameters = dict({'wait_for': ['analysis']}, **simulation_parameters)
        self.simulation = simulation(namespace, scene, values, environment,
                                     acknowledged_by=['analysis'], **parameters)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.simulation.__exit__()
        self.analysis.__exit__()
        self.results.__exit__()

    def finish(self):
        """Waits until both nodes have ended well."""
        for process in (self.simulation, self.analysis):
            if process.wait() != 0:
                raise AssertionError('a node failed: ' + process.stderr())
