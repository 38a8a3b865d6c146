#!/usr/bin/env python3
"""Sweeps and a reproduced table as job arrays of a real Slurm, which the test starts: whatever happens to jobs, nodes and the
controller, the tables are those of a local sweep, byte for byte.

    slurm_test.py --ljmd PATH [--times N] [CASE ...]

Exit codes: 0 all is well, 1 it is not, 77 something is missing here (1 with LJMD_REQUIRE_PEERS=1 in the environment, if
packages bring it).
"""

import argparse
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "cli"), str(HERE.parent)]

import cluster  # noqa: E402
from harness import DECK, Context, Failure, Result, clean_environment  # noqa: E402
import keeper  # noqa: E402
import waiting  # noqa: E402

PLAIN = ("sweep", "deck.toml", "--grid", "system.temperature=1.2:2.0:3,system.density=0.7|0.8442", "--out", "out")
# Points that take their time and leave checkpoints.
LONG = ("sweep", "deck.toml", "--grid", "system.temperature=1.2:2.0:4", "--set", "stage.production.steps=60000",
        "--set", "output.checkpoint={ every = 500 }", "--out", "out")
LONGER = tuple("system.temperature=1.2:2.0:8" if word == "system.temperature=1.2:2.0:4" else word for word in LONG)
FAILING = ("sweep", "deck.toml", "--out", "out", "--grid", "stage.production.time_step=0.001|0.4|0.002", "--force")
ROWS = ("reproduce", "verlet1967", "--quick", "--rows", "0.85:0.786,0.45:2.935", "--out", "out")
SLURM = ("--slurm", "--partition=all --time=30")


class Bench:
    """One cluster, and for each case a directory `here` from which arrays are submitted."""

    def __init__(self, ljmd, directory):
        self.cluster = cluster.Cluster(directory / "cluster")
        self.ljmd, self.directory, self.cases = ljmd, directory, 0
        self.locals = {}  # what was run here, by command
        self.environment = {**clean_environment(), **self.cluster.environment, "LANG": "C"}

    def fresh(self):
        self.cases += 1
        self.here = self.folder(f"case{self.cases}")

    def folder(self, name):
        (self.directory / name).mkdir()
        context = Context(self.ljmd, self.directory / name, None)
        context.deck()
        return context

    def local(self, command):
        """Where the command was run without Slurm, and what came of it."""
        if command not in self.locals:
            context = self.folder(f"local{len(self.locals)}")
            self.locals[command] = (context, context.run(*command))
        return self.locals[command]

    def run(self, *arguments, **variables):
        done = subprocess.run([self.ljmd, *arguments], cwd=self.here.dir, env={**self.environment, **variables}, capture_output=True,
                              text=True, stdin=subprocess.DEVNULL, timeout=waiting.PATIENCE, check=False)
        return Result(done.returncode, done.stdout, done.stderr)

    def expect(self, code, *arguments, **variables):
        return self.here.expect(code, self.run(*arguments, **variables))

    def submit(self, *command, **variables):
        """@return the number of the array"""
        result = self.expect(0, *command, *SLURM, "--json", **variables)
        words = json.loads(result.out)["submitted"].split()
        self.here.equal(words[0], "array", "what was submitted")
        return words[1]

    def status(self, command="sweep"):
        return json.loads(self.expect(0, command, "--status", "out", "--json").out)

    def begun(self, count):
        """Runs that have written two checkpoints and are not finished, once there are so many."""
        def look():
            found = [path.parent for path in self.here.dir.glob("out/points/*/checkpoint.2")]
            return found if len([one for one in found if not (one / "results.json").exists()]) >= count else None
        return waiting.until(look, f"{count} points have begun")

    def resumptions(self):
        return [json.loads(path.read_text())["resumed_at_steps"] for path in self.here.dir.glob("out/points/*/run.json")]

    def check_gathered(self, *command, code=0):
        """Once more the command that submits gathers all, and says and writes what a local one does."""
        gathered = self.expect(code, *command, *SLURM)
        context, local = self.local(command)
        self.here.equal((gathered.code, gathered.out), (local.code, local.out), "the table on the screen")
        for name in ("sweep.csv", "rows.csv", "rows.md", "results.json"):
            ours, theirs = self.here.dir / "out" / name, context.dir / "out" / name
            self.here.equal(ours.exists(), theirs.exists(), name)
            if ours.exists():
                self.here.equal(ours.read_bytes(), theirs.read_bytes(), name)
        return gathered


def plain(b):
    b.submit(*PLAIN)
    b.cluster.wait_for_tasks()
    b.here.equal(b.status()["states"]["finished"], 6, "finished points")
    b.here.check(not (b.here.dir / "out/sweep.csv").exists(), "nobody has gathered yet")
    b.check_gathered(*PLAIN)
    b.here.equal(b.cluster.tasks(), [], "tasks of a sweep with nothing missing")


def several_points_in_a_task(b):
    b.submit(*PLAIN, "--jobs", "1", "--set", "system.seed=3")
    array = (b.here.dir / "out/slurm/worker.sh").read_text()
    b.here.contains(array, '/6"')
    b.cluster.wait_for_tasks()
    b.check_gathered(*PLAIN, "--set", "system.seed=3")


def cancelled_and_given_again(b):
    array = b.submit(*LONG)
    begun = b.begun(1)
    b.cluster.command("scancel", array)
    b.cluster.wait_for_tasks()
    states = b.status()["states"]
    b.here.check(states["stopped"] >= 1 and states["failed"] == 0 and states["running"] == 0, f"states {states}")
    stopped = [path for path in begun if not (path / "results.json").exists()]
    for path in stopped:
        b.here.contains((path.parent / f"{path.name}.log").read_text(), "stopped after step ")
    b.submit(*LONG)
    b.cluster.wait_for_tasks()
    b.check_gathered(*LONG)
    for path in stopped:
        steps = json.loads((path / "run.json").read_text())["resumed_at_steps"]
        b.here.check(len(steps) == 1 and steps[0] > 0, f"{path.name}: resumed at {steps}")


def warned_before_the_time_limit(b):
    """The signal that Slurm sends to the worker before the time limit; here it is sent at once."""
    array = b.submit(*LONG)
    b.begun(1)
    b.cluster.command("scancel", "--state=PENDING", array)
    b.cluster.command("scancel", "--state=RUNNING", "--batch", "--signal=USR1", array)
    b.cluster.wait_for_tasks()
    states = b.status()["states"]
    b.here.check(states["stopped"] >= 1 and states["failed"] == 0, f"states {states}")
    b.submit(*LONG)
    b.cluster.wait_for_tasks()
    b.check_gathered(*LONG)


def a_node_down(b):
    """Its tasks go back to the queue and wait there. The study is submitted again without waiting, while the worker on the
    lost node still runs: nobody can reach it."""
    array = b.submit(*LONG)
    b.begun(2)
    b.cluster.kill("n1")
    b.cluster.command("scontrol", "update", "NodeName=n1", "State=DOWN", "Reason=test")
    b.expect(9, *LONG, *SLURM)
    b.cluster.command("scancel", array)
    waiting.until(lambda: all("COMPLETING" in task for task in b.cluster.tasks() or []), "the array is cancelled")
    b.submit(*LONG)
    b.cluster.wait_for_tasks()
    b.cluster.start_node("n1")
    waiting.until(lambda: b.cluster.node_states() == {"n1": "idle", "n2": "idle"}, "both nodes are idle")
    b.check_gathered(*LONG)


def the_controller_killed(b):
    """Tasks run on; nothing is submitted in the meantime."""
    array = b.submit(*LONGER)
    b.begun(1)
    b.cluster.wait_until_saved()
    b.cluster.kill("slurmctld")
    result = b.expect(7, *LONGER, *SLURM)
    b.here.contains(result.err, "error: squeue fails with exit status 1. It is not known whether the study is queued already")
    b.cluster.start_controller()
    # It may take tasks for running that have ended meanwhile, or that it was about to start: what still hangs in the queue
    # when no point has been running for many looks is cancelled, as a person would do.
    quiet = 0
    while quiet < 50 and b.cluster.tasks() != []:
        states = b.status()["states"]
        quiet = 0 if states["running"] else quiet + 1
    b.cluster.command("scancel", array, check=False)
    b.cluster.wait_for_tasks()
    if b.status()["states"]["finished"] < 8:
        b.submit(*LONGER)
        b.cluster.wait_for_tasks()
    b.check_gathered(*LONGER)


def a_failing_point(b):
    b.submit(*FAILING)
    b.cluster.wait_for_tasks()
    for _ in range(2):
        status = b.status()
        b.here.equal((status["states"]["finished"], status["states"]["failed"]), (2, 1), "states")
        b.here.contains(status["runs"][1]["words"], "exit code 5: error: ")
        gathered = b.check_gathered(*FAILING, code=5)
        b.here.contains(gathered.err, "error: 1 of 3 points failed; they are tried again: array ")
        b.here.contains(gathered.err, " of 1 task\n  time_step=0.4: exit code 5: error: ")
        b.cluster.wait_for_tasks()


def submitted_twice(b):
    array = b.submit(*LONG)
    result = b.expect(9, *LONG, *SLURM)
    b.here.contains(result.err, f"error: array {array} of {b.here.dir}/out is queued or running. Nothing was submitted.")
    b.begun(1)
    b.expect(9, *LONG, *SLURM)
    b.cluster.wait_for_tasks()
    b.check_gathered(*LONG)


def variables_of_slurm(b):
    """Those by which squeue would hide the array, and sbatch would wait for it or make another one."""
    elsewhere = {"SLURM_CLUSTERS": "other", "SBATCH_CLUSTERS": "other"}
    array = b.submit(*LONG, SBATCH_WAIT="1", SBATCH_ARRAY_INX="7", SBATCH_JOB_NAME="mine", **elsewhere)
    b.begun(1)  # the command has not waited for the end of the array
    tasks = b.cluster.command("squeue", "--noheader", "--array", "--format=%F %K").stdout.splitlines()
    b.here.check(tasks and all(task.split()[0] == array and int(task.split()[1]) <= 4 for task in tasks), f"tasks {tasks} of array {array}")
    for name, value in {"SQUEUE_STATES": "COMPLETED", "SQUEUE_PARTITION": "none", "SQUEUE_USERS": "nobody", "SQUEUE_ACCOUNT": "a",
                        "SQUEUE_QOS": "a", "SQUEUE_LICENSES": "a", "SQUEUE_FORMAT": "%i", "SQUEUE_NAMES": "a"}.items():
        result = b.expect(9, *LONG, *SLURM, **{name: value}, **elsewhere)
        b.here.contains(result.err, f"error: array {array} of ")
    b.cluster.command("scancel", array)
    b.cluster.wait_for_tasks()


def options_are_those_of_sbatch(b):
    """What ljmd takes for an option with, or without, a value is one for sbatch."""
    told = b.expect(2, *PLAIN, "--slurm", "--wait").err
    names = re.findall(r"--([a-z-]+)(?: \(-(\w)\))?(?:,|$)", told.split("in a word: ")[1].strip())
    b.here.check(len(names) > 50, f"{len(names)} options are told")
    for name, letter in names:
        needs_value = "needs a value" in b.run(*PLAIN, "--slurm", f"--{name}", PATH="/nowhere").err
        for word in (f"--{name}", f"-{letter}") if letter else (f"--{name}",):
            said = b.cluster.command("sbatch", word, check=False).stderr
            b.here.check(not re.search("unrecognized|invalid option|ambiguous", said), f"sbatch has no {word}: {said}")
            b.here.equal("requires an argument" in said, needs_value, f"whether {word} needs a value")


def submitted_twice_at_once(b):
    both = [subprocess.Popen([b.ljmd, *PLAIN, *SLURM], cwd=b.here.dir, env=b.environment, stdin=subprocess.DEVNULL,
                             stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) for _ in range(2)]
    codes = sorted(one.wait(waiting.PATIENCE) for one in both)
    b.here.equal(codes, [0, 9], "exit codes")
    b.cluster.wait_for_tasks()
    b.check_gathered(*PLAIN)


def refused_by_slurm(b):
    result = b.expect(2, *PLAIN, "--slurm", "--partition=none")
    b.here.contains(result.err, "error: sbatch does not take the array. Nothing was submitted.\n  sbatch: error: ")
    b.here.equal(b.status()["states"]["not begun"], 6, "points that have not begun")


def a_reproduced_table(b):
    b.submit(*ROWS)
    b.cluster.wait_for_tasks()
    b.here.equal(b.status("reproduce")["states"]["finished"], 2, "finished rows")
    b.check_gathered(*ROWS)


CASES = [plain, several_points_in_a_task, cancelled_and_given_again, warned_before_the_time_limit, a_node_down,
         the_controller_killed, a_failing_point, submitted_twice, submitted_twice_at_once, variables_of_slurm, options_are_those_of_sbatch,
         refused_by_slurm, a_reproduced_table]


def run_cases(ljmd, directory, cases, times):
    bench = Bench(ljmd, directory)
    failed = 0
    for turn in range(times):
        for case in cases:
            bench.fresh()
            try:
                case(bench)
                print(f"passed: {case.__name__}", flush=True)
            except (Failure, LookupError, OSError, ValueError, subprocess.SubprocessError) as error:
                failed += 1
                print(f"FAILED in turn {turn + 1}: {case.__name__}: {type(error).__name__}: {error}\n"
                      f"{getattr(error, 'stderr', None) or ''}\n{bench.cluster.log('slurmctld')}", flush=True)
                return 1  # the cluster may be in disorder
    return 1 if failed else 0


def of_cluster(directory):
    """Processes that have the directory of a cluster in their environments."""
    found = []
    for path in Path("/proc").glob("[0-9]*/environ"):
        try:
            if f"SLURM_CONF={directory}".encode() in path.read_bytes():
                found.append(int(path.parent.name))
        except OSError:  # it has ended
            pass
    return [pid for pid in found if pid != os.getpid()]


def no_daemon_is_left():
    """Nor a file, however the test ends: any of its processes is killed, or all that one can reach by their group, or the test
    is told to end."""
    for which in ("the test", "its keeper", "what was called", "its group", "told to end"):
        with subprocess.Popen([sys.executable, __file__, "--hold"], stdout=subprocess.PIPE, text=True, start_new_session=True) as process:
            folder, test, kept_by = process.stdout.readline().split()
            if not of_cluster(folder):
                raise Failure("no cluster has come up")
            if which == "its group":
                os.killpg(process.pid, signal.SIGKILL)
            else:
                victim = {"the test": int(test), "its keeper": int(kept_by)}.get(which, process.pid)
                os.kill(victim, signal.SIGTERM if which == "told to end" else signal.SIGKILL)
            process.wait(waiting.PATIENCE)
        waiting.until(lambda: not of_cluster(folder) and not Path(folder).exists(), f"all has gone after an end of {which}")


def hold():
    """Start a cluster, say where and as whom, and wait to be ended."""
    folder = tempfile.gettempdir()
    cluster.Cluster(Path(folder) / "cluster")
    print(folder, os.getpid(), os.getppid(), flush=True)
    while True:
        signal.pause()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--ljmd", type=Path, help="the program")
    parser.add_argument("--times", type=int, default=1, help="try all cases that many times")
    parser.add_argument("--hold", action="store_true", help=argparse.SUPPRESS)
    parser.add_argument("cases", nargs="*", metavar="CASE", help=", ".join(case.__name__ for case in CASES))
    options = parser.parse_args()
    if options.hold:
        return hold()
    if lacking := cluster.missing():
        required = os.environ.get("LJMD_REQUIRE_PEERS") == "1"
        print(f"{'FAIL, as LJMD_REQUIRE_PEERS=1' if required else 'skipped'}: there is no {lacking}")
        return 1 if required else 77
    if lacking := cluster.nameless():
        print(f"skipped: there is no {lacking}")
        return 77
    cases = [case for case in CASES if not options.cases or case.__name__ in options.cases]
    code = run_cases(str(options.ljmd.resolve()), Path(tempfile.gettempdir()), cases, options.times)
    if not options.cases and code == 0:
        no_daemon_is_left()
        print("passed: no_daemon_is_left")
    return code


if __name__ == "__main__":
    sys.exit(keeper.kept(main))
