"""Prepared sweeps and tables, and the workers that run them: any number of them, at once, killed, stopped, or sent twice."""

import json
import os
import re
import shutil
import signal
import subprocess
from pathlib import Path

from harness import Case, Skip, clean_environment, held, run_outputs, snapshot
import waiting
from sweeps import children, outputs, times

REQUEST = ("sweep", "deck.toml", "--grid", "system.temperature=1.2:2.0:3,system.density=0.7|0.8442", "--out")
FIRST = "points/temperature=1.2,density=0.7"
# Points that take their time and leave checkpoints.
LONG = ("sweep", "deck.toml", "--grid", "system.temperature=1.2:2.0:3", "--set", "stage.production.steps=20000", "--set",
        "output.checkpoint={ every = 500 }", "--out")
ROWS = ("reproduce", "verlet1967", "--quick", "--rows", "0.85:0.786,0.45:2.935", "--out")
PAGE = Path(__file__).resolve().parents[2] / "docs/slurm.md"


def start(t, *arguments):
    return subprocess.Popen([t.ljmd, *arguments], cwd=t.dir, env=clean_environment(), stdin=subprocess.DEVNULL,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def end(process):
    out, err = process.communicate(timeout=waiting.PATIENCE)
    return process.returncode, out, err


def states(t, directory="out"):
    return {name: count for name, count in
            json.loads(t.run_well("sweep", "--status", directory, "--json").out)["states"].items() if count}


def check_alike(t, request, directory="out"):
    """The table that is gathered, and the files of each point, are those of a sweep that one command has run."""
    gathered = t.run_well(*request, directory, "--quiet")
    whole = t.run_well(*request, "whole", "--quiet")
    t.equal(gathered.out.replace(directory, "whole"), whole.out, "the table")
    t.equal(t.read(f"{directory}/sweep.csv"), t.read("whole/sweep.csv"), "sweep.csv")
    for point in (t.dir / "whole/points").iterdir():
        if point.is_dir():
            t.check(outputs(point) == outputs(t.dir / directory / "points" / point.name), f"files of {point.name}")


def prepared_and_worked_on(t):
    t.deck()
    prepared = t.run_well(*REQUEST, "out", "--prepare")
    t.equal(prepared.out, "6 points prepared in out\nto run them: ljmd sweep --work K/T out\n", "stdout")
    t.equal(t.files("out"), ["points", "points/deck.toml", "sweep.json"], "files")
    t.equal(states(t), {"not begun": 6}, "states")
    first = t.run_well("sweep", "--work", "1/4", "out", "--jobs", "1")
    t.equal((first.out, first.err.count("\n")), ("", 2), "stdout and lines of progress of a worker")
    t.contains(first.err, "[2/2] temperature=2,density=0.7: T ")
    t.equal(states(t), {"finished": 2, "not begun": 4}, "states")
    done = times(t.dir / "out" / FIRST)
    for share in ("2/4", "3/4", "4/4", "1/4"):
        t.run_well("sweep", "--work", share, "out", "--quiet")
    t.equal(states(t), {"finished": 6}, "states")
    t.check(not (t.dir / "out/sweep.csv").exists(), "a worker gathers")
    check_alike(t, REQUEST)
    t.equal(times(t.dir / "out" / FIRST), done, "times of files of a finished point")


def prepared_twice(t):
    t.deck()
    t.equal(json.loads(t.run_well(*REQUEST, "out", "--prepare", "--json").out), {"directory": "out", "prepared": 6}, "JSON")
    before = snapshot(t.dir / "out")
    t.run_well(*REQUEST, "out", "--prepare")
    t.equal(snapshot(t.dir / "out"), before, "files")


def a_share_without_points(t):
    t.deck()
    t.run_well(*REQUEST, "out", "--prepare")
    result = t.run_well("sweep", "--work", "7/7", "out")
    t.equal((result.out, result.err), ("", ""), "output")


def many_workers_at_once(t):
    """All have the same share, so each comes to points of the others."""
    t.deck()
    t.run_well(*REQUEST, "out", "--prepare")
    workers = [start(t, "sweep", "--work", "1/1", "out", "--jobs", "2") for _ in range(4)]
    for worker in workers:
        code, out, err = end(worker)
        t.equal((code, out), (0, ""), f"exit code and stdout of a worker that says {err!r}")
        t.equal(err.count(": T "), 6, "points that a worker sees at their ends")
    for record in (t.dir / "out/points").glob("*/run.json"):
        t.equal(json.loads(record.read_text())["resumed_at_steps"], [], f"resumptions in {record}")
    check_alike(t, REQUEST)


def ended_and_taken_over(number):
    """Another worker with the same share waits for the point of one that is stopped or killed, and completes it."""
    def test(t):
        t.deck()
        t.run_well(*LONG, "out", "--prepare")
        worker = start(t, "sweep", "--work", "1/3", "out")
        point = t.dir / "out/points/temperature=1.2"
        waiting.until((point / "checkpoint.2").exists, "the second checkpoint", worker)
        t.equal(states(t), {"running": 1, "not begun": 2}, "states")
        other = start(t, "sweep", "--work", "1/3", "out")
        t.contains(other.stderr.readline(), f"waiting for the run that is still writing to {point.relative_to(t.dir)}\n")
        worker.send_signal(number)
        code, _, err = end(worker)
        t.equal(code, -number if number == signal.SIGKILL else 128 + number, "exit code")
        if number != signal.SIGKILL:
            t.contains(err, "stopped; to go on, give the same command again\n")
        t.equal(end(other)[0], 0, "exit code of the other")
        steps = t.json("out/points/temperature=1.2/run.json")["resumed_at_steps"]
        t.check(len(steps) == 1 and steps[0] > 0, f"resumed at {steps}")
        t.run_well("sweep", "--work", "2/3", "out", "--quiet")
        check_alike(t, LONG)
    return test


def out_of_time(t):
    """In the midst of runs that no machine brings to their ends, and before the first one."""
    t.deck()
    endless = [word.replace("=20000", "=1000000000") for word in LONG]
    t.run_well(*endless, "endless", "--prepare")
    result = t.expect(75, t.run("sweep", "--work", "1/1", "endless", "--jobs", "3", "--walltime", "0.5s"))
    t.contains(result.err, "stopped; to go on, give the same command again\n")
    found = states(t, "endless")
    t.check(set(found) <= {"stopped", "not begun"}, f"states {found}")
    t.run_well(*LONG, "out", "--prepare")
    result = t.expect(75, t.run("sweep", "--work", "1/1", "out", "--jobs", "3", "--walltime", "1e-9 s"))
    t.contains(result.err, "stopped; to go on, give the same command again\n")
    found = states(t)
    t.check("failed" not in found and "running" not in found, f"states {found}")
    t.run_well("sweep", "--work", "1/1", "out", "--quiet")
    check_alike(t, LONG)


def told_to_end_twice_at_once(t):
    """As Slurm does, which sends SIGTERM to the worker and to its runs, two times: all stop with checkpoints."""
    t.deck()
    t.run_well(*LONG, "out", "--prepare")
    worker = start(t, "sweep", "--work", "1/3", "out")
    waiting.until((t.dir / "out/points/temperature=1.2/checkpoint.2").exists, "the second checkpoint", worker)
    victims = children(worker)
    t.equal(len(victims), 1, "runs of the worker")
    for _ in range(2):
        for process in (*victims, worker.pid):
            os.kill(process, signal.SIGTERM)
    t.equal(end(worker)[0], 143, "exit code")
    t.equal(states(t), {"stopped": 1, "not begun": 2}, "states")
    t.contains(t.read("out/points/temperature=1.2.log"), "stopped after step ")


def a_point_that_fails(t):
    t.deck()
    request = ("sweep", "deck.toml", "--out", "out", "--grid", "stage.production.time_step=0.001|0.4|0.002", "--force")
    t.run_well(*request, "--prepare")
    result = t.expect(5, t.run("sweep", "--work", "1/1", "out", "--quiet"))
    t.contains(result.err, "error: 1 of 3 points failed; the same command tries them again\n  time_step=0.4: exit code 5: error: ")
    status = json.loads(t.run_well("sweep", "--status", "out", "--json").out)
    t.equal({name: count for name, count in status["states"].items() if count}, {"finished": 2, "failed": 1}, "states")
    t.contains(status["runs"][1]["words"], "exit code 5: error: ")
    t.equal([run["total_steps"] for run in status["runs"]], [60] * 3, "steps")
    t.contains(t.run_well("sweep", "--status", "out").out, "  time_step=0.4    failed")


def another_run_in_a_point(t):
    """A worker leaves it alone, and says so; the command that prepares replaces it with --force."""
    t.deck()
    t.run_well(*REQUEST, "out", "--prepare")
    t.run_well("run", "deck.toml", "--set", "system.seed=5", "--out", f"out/{FIRST}", "--quiet")
    before = snapshot(t.dir / "out" / FIRST)
    result = t.expect(5, t.run("sweep", "--work", "1/6", "out", "--quiet"))
    t.contains(result.err, f"out/{FIRST} holds a run of another deck or with other settings. It was left as it is")
    t.check(snapshot(t.dir / "out" / FIRST) == before, "the run was changed")
    t.contains(t.expect(2, t.run(*REQUEST, "out", "--quiet")).err, "holds a run that is not of this sweep; --force makes it anew")
    t.run_well(*REQUEST, "out", "--force", "--prepare")
    t.run_well("sweep", "--work", "1/1", "out", "--quiet")
    check_alike(t, REQUEST)


def damaged_records(t):
    """One damaged record hides no other point; --force begins that point anew."""
    t.deck()
    t.run_well(*REQUEST, "out", "--prepare")
    t.run_well("sweep", "--work", "1/1", "out", "--quiet")
    (t.dir / "out" / FIRST / "run.json").write_text("{")
    t.equal(states(t), {"finished": 5, "failed": 1}, "states")
    t.contains(t.expect(5, t.run("sweep", "--work", "1/1", "out", "--quiet")).err, "run.json")
    t.run_well(*REQUEST, "out", "--force", "--prepare")
    check_alike(t, REQUEST)


def a_deck_changed_by_hand(t):
    t.deck()
    t.run_well(*REQUEST, "out", "--prepare")
    with open(t.dir / "out/points/deck.toml", "a", encoding="utf-8") as deck:
        deck.write("# later\n")
    t.contains(t.expect(5, t.run("sweep", "--work", "1/6", "out", "--quiet")).err, "deck.toml is not the deck that was prepared")
    t.run_well(*REQUEST, "out", "--prepare")
    t.run_well("sweep", "--work", "1/6", "out", "--quiet")


def a_point_killed(t):
    """A run that something else has killed has failed, and the status says how; it is resumed all the same."""
    t.deck()
    t.run_well(*LONG, "out", "--prepare")
    worker = start(t, "sweep", "--work", "1/3", "out", "--quiet")
    waiting.until((t.dir / "out/points/temperature=1.2/checkpoint.2").exists, "the second checkpoint", worker)
    os.kill(children(worker)[0], signal.SIGKILL)
    code, _, err = end(worker)
    t.equal(code, 5, "exit code")
    t.contains(err, "error: 1 of 1 points failed; the same command tries them again\n  temperature=1.2: exit code 137 (signal 9)")
    status = json.loads(t.run_well("sweep", "--status", "out", "--json").out)
    t.equal((status["runs"][0]["state"], status["runs"][0]["words"]), ("failed", "exit code 137 (signal 9)"), "state and words")
    t.run_well("sweep", "--work", "1/1", "out", "--quiet")
    check_alike(t, LONG)


def held_by_hand(t):
    """A run that somebody has resumed by hand is waited for."""
    t.deck()
    t.run_well(*REQUEST, "out", "--prepare")
    (t.dir / "out" / FIRST).mkdir()
    with held(t.dir / "out" / FIRST):
        worker = start(t, "sweep", "--work", "1/6", "out")
        t.equal(worker.stderr.readline(), f"waiting for the run that is still writing to out/{FIRST}\n", "stderr")
    t.equal(end(worker)[0], 0, "exit code")
    t.equal(states(t), {"finished": 1, "not begun": 5}, "states")


def replaced_beside_workers(t):
    """Another sweep does not take the directory of one whose workers run."""
    t.deck()
    t.run_well(*LONG, "out", "--prepare")
    worker = start(t, "sweep", "--work", "1/3", "out")
    waiting.until((t.dir / "out/points/temperature=1.2/checkpoint.2").exists, "the second checkpoint", worker)
    before = t.read("out/sweep.json")
    other = ("sweep", "deck.toml", "--grid", "system.density=0.7|0.8", "--out", "out", "--prepare")
    t.expect(2, t.run(*other))
    refused = t.expect(9, t.run(*other, "--force"))
    t.equal((worker.poll(), refused.out), (None, ""), "the worker, for which nobody waits, and stdout")
    t.check("waiting" not in refused.err, f"it waits:\n{refused.err}")
    t.equal(t.read("out/sweep.json"), before, "sweep.json")
    worker.send_signal(signal.SIGUSR1)
    t.equal(end(worker)[0], 138, "exit code of the worker")
    t.run_well(*other, "--force")
    t.check(t.read("out/sweep.json") != before, "the sweep was not replaced")


def rows_of_a_table(t):
    t.expect(2, t.run("reproduce", "--work", "1/1", "out"))
    t.contains(t.run_well(*ROWS, "out", "--prepare").out, "2 rows prepared in out\nto run them: ljmd reproduce --work K/T out\n")
    workers = [start(t, "reproduce", "--work", share, "out") for share in ("1/2", "2/2", "1/2")]
    for worker in workers:
        code, out, err = end(worker)
        t.equal((code, out), (0, ""), f"exit code and stdout of a worker that says {err!r}")
        t.contains(err, "[1/1] rho ")
    t.contains(t.run_well("reproduce", "--status", "out").out, "a reproduced table of 2 runs\nfinished      2\n")
    t.check(not (t.dir / "out/rows.csv").exists(), "a worker gathers")
    gathered, whole = t.run_well(*ROWS, "out", "--quiet"), t.run_well(*ROWS, "whole", "--quiet")
    t.equal(gathered.out.replace("out", "whole"), whole.out.replace("out", "whole"), "the table")
    for name in ("rows.csv", "rows.md", "isotherms.csv", "results.json"):
        t.equal(t.read(f"out/{name}"), t.read(f"whole/{name}"), name)
    found = run_outputs(t.dir / "out/rows/rho0.4500-T2.935"), run_outputs(t.dir / "whole/rows/rho0.4500-T2.935")
    t.equal(found[0]["thermo.csv"], found[1]["thermo.csv"], "thermo.csv")


def with_gnu_parallel(t):
    """The line of docs/slurm.md."""
    if not shutil.which("parallel"):
        if os.environ.get("LJMD_REQUIRE_PEERS") == "1":
            raise OSError("there is no GNU parallel, and LJMD_REQUIRE_PEERS=1")
        raise Skip("there is no GNU parallel")
    line = re.search(r"^parallel -j 8 ljmd .*$", PAGE.read_text(encoding="utf-8"), re.M).group().replace("spread", "out")
    t.deck()
    t.run_well(*REQUEST, "out", "--prepare")
    (t.dir / "bin").mkdir()
    (t.dir / "bin/ljmd").symlink_to(t.ljmd)
    environment = {**clean_environment(), "PATH": f"{t.dir}/bin:{os.environ['PATH']}", "HOME": str(t.dir)}
    t.expect(0, t.command(["/bin/sh", "-c", line], env=environment))
    shutil.rmtree(t.dir / "bin")
    check_alike(t, REQUEST)


def without_slurm(t):
    """Nothing is touched where there is no sbatch."""
    t.deck()
    environment = {**clean_environment(), "PATH": str(t.dir)}
    for request in (REQUEST, ROWS):
        result = t.expect(2, t.run(*request, "out", "--slurm", "-p all", env=environment))
        t.contains(result.err, "error: --slurm: there is no sbatch on this computer. Nothing was run.\n")
    t.golden(result.err)
    t.equal(t.files(), ["deck.toml"], "files")


def submitted_by_another_path(t):
    """However the directory is reached, it is one and the same array that is looked for in the queue."""
    t.deck()
    (t.dir / "bin").mkdir()
    # A queue in which an array stays: squeue tells of the names that sbatch was given.
    for name, text in (("sbatch", 'for word; do case $word in --job-name=*) echo "$word" >> queue; esac; done; echo 17'),
                       ("squeue", 'for word; do case $word in --name=*) name=$word; esac; done\n'
                                  'grep -q -x -e "--job-${name#--}" queue 2> /dev/null && echo 17 PENDING; true')):
        (t.dir / "bin" / name).write_text(f"#!/bin/sh\ncd '{t.dir}'\n{text}\n", encoding="utf-8")
        (t.dir / "bin" / name).chmod(0o755)
    environment = {**clean_environment(), "PATH": f"{t.dir}/bin:{os.environ['PATH']}"}
    slurm = ("--slurm", "")
    (t.dir / "link").symlink_to("real")
    (t.dir / "real").mkdir()
    t.contains(t.run_well(*REQUEST, "real/out", *slurm, env=environment).out, "submitted: array 17 of 6 tasks\n")
    for path in ("real/out", "link/out", "./real//out/", "link/../real/out", t.dir / "real/out", t.dir / "link/out"):
        result = t.expect(9, t.run(*REQUEST, path, *slurm, env=environment))
        t.contains(result.err, "error: array 17 of ")
        t.contains(result.err, " is queued or running. Nothing was submitted.\n")
    t.run_well(*REQUEST, "link/other", *slurm, env=environment)
    t.equal(len(set(t.read("queue").split())), 2, "names of arrays")
    t.run_well(*REQUEST, "it's mine", *slurm, env=environment)
    result = t.expect(9, t.run(*REQUEST, "it's mine", *slurm, env=environment))
    command = re.search("how far it is: ljmd (.*)", result.err).group(1)
    t.contains(t.expect(0, t.shell(f'"$LJMD" {command}')).out, "not begun     6\n")


def refused(*arguments, prepare=None):
    """A case: a command is refused with a golden message, and nothing is changed."""
    def test(t):
        t.deck()
        if prepare:
            t.run_well(*prepare, "out", "--prepare")
        before = snapshot(t.dir)
        result = t.expect(2, t.run(*arguments))
        t.equal((result.out, snapshot(t.dir)), ("", before), "stdout and files")
        t.golden(result.err)
    return test


def cases():
    shares = ("1", "0/2", "3/2", "1/2/3", "a/b", "1/10001", "-1/2")
    work = ("sweep", "--work", "1/2", "out")
    return [Case(test.__name__.replace("_", " "), test)
            for test in (prepared_and_worked_on, prepared_twice, a_share_without_points, many_workers_at_once, out_of_time,
                         told_to_end_twice_at_once, a_point_that_fails, a_point_killed, another_run_in_a_point, damaged_records,
                         a_deck_changed_by_hand, held_by_hand, replaced_beside_workers,
                         rows_of_a_table, with_gnu_parallel, without_slurm, submitted_by_another_path)] + [
        Case("stopped by SIGTERM and taken over", ended_and_taken_over(signal.SIGTERM)),
        Case("stopped by SIGUSR1 and taken over", ended_and_taken_over(signal.SIGUSR1)),
        Case("killed and taken over", ended_and_taken_over(signal.SIGKILL))] + [
        Case(f"the share '{share}'", refused("sweep", f"--work={share}", "out", prepare=REQUEST)) for share in shares] + [
        Case("a worker where nothing is prepared", refused(*work)),
        Case("a worker of a sweep in a table", refused(*work, prepare=ROWS)),
        Case("a worker of a table in a sweep", refused("reproduce", "--work", "1/2", "out", prepare=REQUEST)),
        Case("a worker with a grid", refused(*work, "--grid", "system.density=0.7|0.8", prepare=REQUEST)),
        Case("a worker that prepares", refused(*work, "--prepare", prepare=REQUEST)),
        Case("a wall time that is none", refused(*work, "--walltime", "soon", prepare=REQUEST)),
        Case("a wall time without a share", refused(*REQUEST, "out", "--walltime", "2h")),
        Case("the status of nothing", refused("sweep", "--status", "out")),
        Case("the status of a deck", refused("sweep", "--status", "deck.toml")),
        Case("the status of a table that is none", refused("reproduce", "--status", "out")),
        Case("the tasks of Slurm given", refused(*REQUEST, "out", "--slurm", "-p all --array=1-3")),
        Case("an option of Slurm without its value", refused(*ROWS, "out", "--slurm", "-t 30 -p")),
        Case("prepared and submitted", refused(*REQUEST, "out", "--prepare", "--slurm", "")),
        Case("prepared with another grid", refused(*REQUEST[:3], "system.density=0.7|0.8", "--out", "out", "--prepare",
                                                   prepare=REQUEST)),
        Case("prepared with other settings", refused(*REQUEST, "out", "--set", "system.seed=3", "--prepare", prepare=REQUEST)),
        Case("prepared with a mistake", refused(*REQUEST[:3], "system.density=-0.7|0.8", "--out", "out", "--prepare"))]
