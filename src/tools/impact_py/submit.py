"""Gives the shards of a sweep or a reproduction to Slurm: a job array that simulates them, and a job
after it that collects them. The same command again gives it what is missing."""

import argparse
import json
import math
import re
import shlex
import subprocess
import sys
from pathlib import Path

from .program import InputError, Parser, run

PROGRAMS = ("sweep", "reproduce")
SHARD = 15 * 60  # s that a shard should take by its forecast, which is good to a factor of 3
MARGIN = 4       # of the time limit of a task over the forecast
LEAST_LIMIT = 10  # min

SIMULATE = """#!/bin/bash
#SBATCH --job-name={name}
#SBATCH --array={shards}
#SBATCH --time={limit}
#SBATCH --ntasks=1
#SBATCH --cpus-per-task={jobs}
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output={log}/shard-%a.log
shard=$SLURM_ARRAY_TASK_ID
# A node that Slurm has given up may still be at it.
flock {folder}/"shard-$shard-of-{count}.csv" true
exec {command} --shard "$shard/{count}" --jobs {jobs}
"""

COLLECT = """#!/bin/bash
#SBATCH --job-name={name}-collect
#SBATCH --time={limit}
#SBATCH --ntasks=1
#SBATCH --cpus-per-task={jobs}
#SBATCH --requeue
#SBATCH --output={log}/collect.log
exec {command} --collect --jobs {jobs} {table}
"""


def main():
    """The program submit."""
    parser = Parser("submit", description=__doc__,
                    usage="submit [--tasks N] [--time MINUTES] sweep|reproduce ... --output DIR "
                    "[--jobs N]",
                    epilog="--jobs: processors of a task, 1 if it is not given. Slurm's own settings "
                    "are given by its variables, such as SBATCH_PARTITION or SBATCH_ACCOUNT.")
    parser.add_argument("--tasks", type=positive, metavar="N",
                        help="shards; without it as many as make each about "
                        f"{SHARD // 60} min long")
    parser.add_argument("--time", type=positive, metavar="MINUTES",
                        help=f"time limit of a task; without it {MARGIN} times its forecast")
    parser.add_argument("command", nargs=argparse.REMAINDER,
                        help="sweep or reproduce, as without submit; --output is a folder")
    run(parser, perform)


def positive(text):
    """A whole number from 1 on."""
    if not re.fullmatch(r"[1-9]\d{0,6}", text):
        raise argparse.ArgumentTypeError(f"got {text}, allowed: a whole number from 1 on")
    return int(text)


def perform(arguments):
    """Submits what is missing."""
    command = Command(arguments.command)
    status = command.status()
    refuse_if_queued(command.output)
    plan = Plan(arguments, command, status)
    command.log.mkdir(parents=True, exist_ok=True)
    Path(status["folder"]).mkdir(parents=True, exist_ok=True)
    after = []
    if plan.shards:
        job = submit(command.script("shards"), plan.text_of(SIMULATE))
        after = [f"--dependency=afterany:{job}"]
        print(f"job {job}: {len(plan.shards)} of {plan.count} shards, about "
              f"{minutes(plan.longest)} min each")
    job = submit(command.script("collect"), plan.text_of(COLLECT), *after)
    print(f"job {job}: collects them into {command.table or command.output}\n"
          f"logs: {command.log}")


class Command:
    """What is to be divided: a sweep or a reproduction."""

    def __init__(self, words):
        if not words or words[0] not in PROGRAMS:
            raise InputError(f"got {words[0] if words else 'no program'}, allowed: "
                             f"{' or '.join(PROGRAMS)} with what belongs to it")
        parser = Parser(words[0], add_help=False, allow_abbrev=False)
        parser.add_argument("--output", type=Path, required=True)
        parser.add_argument("--jobs", type=positive, default=1)
        own, self.words = parser.parse_known_args(words[1:])
        for word in self.words:
            if word.partition("=")[0] in ("--shard", "--collect", "--status"):
                raise InputError(f"{word}: submit adds it where it belongs")
        self.jobs = own.jobs
        self.output = own.output.absolute()
        self.log = self.output / "log"
        self.program = str(Path(sys.argv[0]).absolute().parent / words[0])
        # A reproduction knows the names of its tables.
        self.table = self.output / "sweep.csv" if words[0] == "sweep" else None

    def line(self):
        """Its words, to which those that concern shards are added."""
        return [self.program, *self.words, "--output", str(self.output)]

    def script(self, name):
        """Where the script of a job is written."""
        return self.output / f"{name}.sbatch"

    def status(self):
        """How far its shards are."""
        return json.loads(output_of([*self.line(), "--status", "--json"]))


class Plan:
    """Which shards of how many are to be simulated, and how long that takes."""

    def __init__(self, arguments, command, status):
        self.command = command
        self.folder = status["folder"]
        target = min(SHARD, arguments.time * 60 / MARGIN) if arguments.time else SHARD
        self.count = status["shards"] or number_of_shards(
            status, arguments.tasks, target * command.jobs)
        if arguments.tasks and arguments.tasks != self.count:
            raise InputError(f"--tasks: got {arguments.tasks}, {self.folder} has shards of "
                             f"{self.count}; remove them to divide anew")
        if status["shards"]:
            self.shards = [one["shard"] for one in status["unfinished"]]
            seconds = max((one["seconds_left"] for one in status["unfinished"]), default=0)
        else:
            self.shards = list(range(1, self.count + 1))
            seconds = status["seconds_left"] / self.count
        self.longest = seconds / command.jobs
        self.limit = arguments.time or max(LEAST_LIMIT, minutes(MARGIN * self.longest))

    def text_of(self, script):
        """The script of a job."""
        command = self.command
        table = "" if command.table is None else shlex.quote(str(command.table))
        return script.format(
            name=re.sub(r"[^\w.-]", "_", command.output.name), shards=ranges(self.shards),
            limit=self.limit, jobs=command.jobs, log=shlex.quote(str(command.log).replace("%", "%%")),
            folder=shlex.quote(str(Path(self.folder).absolute())), count=self.count,
            command=shlex.join(command.line()), table=table)


def number_of_shards(status, wanted, seconds):
    """So many that each takes about so long, no more than there are runs and than Slurm takes."""
    most = most_tasks()
    if wanted and wanted > most:
        raise InputError(f"--tasks: got {wanted}, allowed by this cluster's MaxArraySize: {most}")
    by_time = math.ceil(status["seconds_left"] / seconds)
    return wanted or max(1, min(by_time, status["runs"], most))


def most_tasks():
    """Of an array whose numbers begin at 1."""
    found = re.search(r"^MaxArraySize\s*=\s*(\d+)", output_of(["scontrol", "show", "config"]), re.M)
    if not found:
        raise InputError("scontrol show config: has no MaxArraySize")
    return max(1, int(found[1]) - 1)


def refuse_if_queued(folder):
    """@throw InputError while a job of a script in this folder waits or runs."""
    for line in output_of(["squeue", "--me", "--noheader", "--format=%F %o"]).splitlines():
        job, _, command = line.strip().partition(" ")
        if Path(command).parent == folder:
            raise InputError(f"{folder}: job {job} is at it; squeue tells how far, scancel ends it")


def submit(script, text, *options):
    """Writes the script and gives it to Slurm; its number there."""
    script.write_text(text)
    return output_of(["sbatch", "--parsable", *options, str(script)]).strip().partition(";")[0]


def output_of(command):
    """Of another program; where that fails, this one ends with its words."""
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              universal_newlines=True, check=False)
    except FileNotFoundError:
        raise InputError(f"{command[0]}: not found; has this machine Slurm?") from None
    if done.returncode != 0:
        lines = done.stderr.strip().splitlines() or [f"ended with {done.returncode}"]
        raise InputError("; ".join(lines))
    return done.stdout


def ranges(numbers):
    """1-3,7 for [1, 2, 3, 7]."""
    parts = []
    for number in numbers:
        if parts and parts[-1][1] == number - 1:
            parts[-1][1] = number
        else:
            parts.append([number, number])
    return ",".join(str(a) if a == b else f"{a}-{b}" for a, b in parts)


def minutes(seconds):
    """Rounded up."""
    return math.ceil(seconds / 60)
