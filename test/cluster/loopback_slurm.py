"""A Slurm of this machine's own: munged, slurmctld and the slurmd of two nodes, below one folder."""

import collections
import os
import pwd
import re
import shutil
import signal
import socket
import subprocess
import time
from pathlib import Path

PROGRAMS = ('munged', 'slurmctld', 'slurmd', 'sbatch')
NODES = ('one', 'two')
TIMEOUT = 300.0  # s, far above what anything here takes

CONFIGURATION = """
ClusterName=loopback
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
# A job that was requeued waits for the end of its first credential.
AuthInfo=socket={folder}/munge.socket,cred_expire=5
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool-%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd-%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd-%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
MailProg=/bin/true
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
SchedulerParameters=sched_interval=2,sched_min_interval=500000,bf_interval=2
PreemptType=preempt/partition_prio
PreemptMode=REQUEUE
SlurmdTimeout={node_timeout}
KillWait=2
ReturnToService=2
MaxArraySize={max_array_size}
NodeName=one NodeHostname={host} NodeAddr=127.0.0.1 Port={ports[1]} CPUs=1
NodeName=two NodeHostname={host} NodeAddr=127.0.0.1 Port={ports[2]} CPUs=1
PartitionName=low Nodes=ALL Default=YES PriorityTier=1 GraceTime={grace}
PartitionName=high Nodes=ALL PriorityTier=2
"""


def is_installed():
    """Whether Debian's slurm-wlm and munge are here."""
    return all(shutil.which(program, path=PATH) for program in PROGRAMS)


PATH = os.environ['PATH'] + ':/usr/sbin:/sbin'


def free_ports(count):
    """Ports that nobody listens on."""
    sockets = [socket.socket() for _ in range(count)]
    for one in sockets:
        one.bind(('127.0.0.1', 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


Process = collections.namedtuple('Process', 'pid parent words node')


def texts_of(path):
    """Of a file that ends each with a zero byte."""
    return path.read_bytes().decode(errors='replace').rstrip('\0').split('\0')


class LoopbackSlurm:
    """Starts with its construction; stop() ends all of it."""

    def __init__(self, folder, node_timeout=10, max_array_size=1001, grace=0):
        self.folder = folder
        self.environment = dict(os.environ, PATH=PATH, SLURM_CONF=str(folder / 'slurm.conf'))
        self._daemons = {}
        for name in ('state', *(f'spool-{node}' for node in NODES)):
            (folder / name).mkdir()
        (folder / 'slurm.conf').write_text(CONFIGURATION.format(
            folder=folder, host=socket.gethostname().partition('.')[0],
            user=pwd.getpwuid(os.getuid()).pw_name, ports=free_ports(3),
            node_timeout=node_timeout, max_array_size=max_array_size, grace=grace))
        try:
            self._start()
        except BaseException:
            self.stop()
            raise

    def _start(self):
        key = self.folder / 'munge.key'
        key.touch(0o600)
        key.write_bytes(os.urandom(128))
        # --force: the folder is for us alone.
        self._run('munged', '--foreground', '--force', f'--socket={self.folder}/munge.socket',
                  f'--key-file={key}', *(f'--{name}-file={self.folder}/munged.{name}'
                                         for name in ('pid', 'log', 'seed')))
        self.wait_for(lambda: (self.folder / 'munge.socket').exists(), 'munged')
        self._run('slurmctld', '-D')
        for node in NODES:
            self.start_node(node)
        self.wait_for(lambda: self.states_of_nodes() == ['idle', 'idle'], 'two idle nodes')

    def _run(self, name, *options, key=None):
        with open(self.folder / 'daemons.log', 'ab') as log:
            self._daemons[key or name] = subprocess.Popen(
                [name, *options], env=self.environment, stdin=subprocess.DEVNULL, stdout=log,
                stderr=log)

    def start_node(self, node):
        """Its slurmd."""
        self._run('slurmd', '-D', '-N', node, key=node)

    def kill_node(self, node):
        """Its slurmd by SIGKILL; jobs go on."""
        self._daemons[node].kill()
        self._daemons.pop(node).wait()

    def kill_jobs(self, node):
        """All that runs on it, first what would tell of its end: with kill_node() as if its power
        went."""
        jobs = [one for one in self.processes() if one.node == node]
        for pid in {one.parent for one in jobs} - {one.pid for one in jobs}:
            os.kill(pid, signal.SIGKILL)
        for one in jobs:
            os.kill(one.pid, signal.SIGKILL)

    def processes(self):
        """Those of jobs."""
        for folder in Path('/proc').glob('[0-9]*'):
            try:
                environment = dict(text.partition('=')[::2] for text in texts_of(folder / 'environ'))
                if environment.get('SLURM_CONF') != self.environment['SLURM_CONF']:
                    continue
                if 'SLURMD_NODENAME' in environment:
                    status = (folder / 'status').read_text()
                    yield Process(int(folder.name), int(re.search(r'PPid:\s*(\d+)', status)[1]),
                                  texts_of(folder / 'cmdline'), environment['SLURMD_NODENAME'])
            except OSError:
                continue  # it has ended, or is another user's

    def states_of_nodes(self):
        """As sinfo has them, in the order of NODES."""
        return self.tell('sinfo', '--noheader', '--Node', '--partition=low',
                         '--format=%T').split()

    def tell(self, *command):
        """What a program of Slurm prints; nothing where it fails."""
        return subprocess.run(command, env=self.environment, stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL, universal_newlines=True,
                              check=False).stdout

    def wait_for(self, condition, what):
        """Until it holds; @throw TimeoutError."""
        end = time.monotonic() + TIMEOUT
        while not condition():
            if time.monotonic() > end:
                raise TimeoutError(f'waited for {what}\n{self.tell("squeue", "--array")}\n'
                                   f'{self.logs()}')
            time.sleep(0.1)

    def wait_for_end(self):
        """Of all jobs."""
        self.wait_for(lambda: not self.tell('squeue', '--noheader', '--states=PD,R,S,CG,CF,RQ'),
                      'the end of all jobs')

    def logs(self):
        """The ends of those of the daemons."""
        return '\n'.join(f'{path}:\n' + '\n'.join(path.read_text().splitlines()[-20:])
                         for path in sorted(self.folder.glob('*.log')))

    def stop(self):
        """Ends jobs and daemons."""
        if 'slurmctld' in self._daemons:
            self.tell('scancel', '--me')
        for name in (*NODES, 'slurmctld', 'munged'):
            daemon = self._daemons.pop(name, None)
            if daemon is None:
                continue
            daemon.send_signal(signal.SIGTERM)
            try:
                daemon.wait(20)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()
        for one in self.processes():  # what was stopped or left behind
            os.kill(one.pid, signal.SIGKILL)
