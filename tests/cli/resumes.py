"""Runs that are stopped, by a signal, by the wall time or by a kill, and resumed; and what cannot be resumed."""

import contextlib
import fcntl
import json
import os
import pathlib
import re
import shutil
import signal
import struct
import subprocess

from harness import (Case, Failure, Result, STARS, check_same_run, clean_environment, decoded, run_outputs,
                     snapshot)
import waiting

LONG = ("--set", "stage.production.steps=20000")
OUTPUTS = [("thermo = { every = 5 }", 'thermo = { every = 5 }\ntrajectory = { format = "xyz", every = 10 }\n'
                                      "[analysis]\nrdf = { bins = 20, every = 10 }")]


def start(t, *arguments, stderr=subprocess.PIPE, **options):
    return subprocess.Popen([t.ljmd, *arguments], cwd=t.dir, env=clean_environment(), stdin=subprocess.DEVNULL,
                            stdout=subprocess.PIPE, stderr=stderr, **options)


def end(process):
    try:
        out, err = process.communicate(timeout=waiting.PATIENCE)
    except subprocess.TimeoutExpired as late:
        process.kill()
        raise Failure("hangs") from late
    return Result(process.returncode, decoded(out), decoded(err))


def has_begun(t, process, out="out"):
    """A checkpoint is there, and rows of thermo.csv after it."""
    waiting.until(lambda: (t.dir / out / "checkpoint.1").exists() and (t.dir / out / "thermo.csv").stat().st_size > 2000,
                  "its first rows", process)


def same_run(t, found, expected):
    check_same_run(t.dir / found, t.dir / expected)


def stopped_by(number):
    def test(t):
        t.deck(*OUTPUTS)
        process = start(t, "run", "deck.toml", "--out", "out", *LONG)
        has_begun(t, process)
        process.send_signal(number)
        result = t.expect(128 + number, end(process))
        t.contains(result.err, f"by {signal.Signals(number).name}; to go on: ljmd resume out\n")
        t.equal(result.out, "", "stdout")
        t.equal(t.json("out/run.json")["finished"], False, "finished")
        again = t.run_well("resume", "out")
        t.contains(again.err, "resuming after step ")
        t.contains(again.out, "compressibility_factor")
        t.run_well("run", "deck.toml", "--out", "whole", "--quiet", *LONG)
        same_run(t, "out", "whole")
        steps = t.json("out/run.json")["resumed_at_steps"]
        t.check(len(steps) == 1 and 0 < steps[0] < 20020, f"resumed_at_steps {steps}")
    return test


def stopped_while_the_start_is_made(t):
    """Nothing would be lost, so nothing is waited for; and making the start takes its part of the wall time."""
    t.deck()
    def slow(atoms):
        return "--set", f'system.lattice={{type="random",atoms={atoms}}}', "--set", "stage.melt.steps=100000"

    process = start(t, "run", "deck.toml", "--out", "out", "--quiet", *slow(2_000_000))
    waiting.until_used(process, 0.2)  # the deck takes less, making the start a hundred times as much
    process.send_signal(signal.SIGTERM)
    t.equal(end(process).code, -signal.SIGTERM, "exit code")
    t.check(not (t.dir / "out").exists(), "there is a directory")
    result = t.expect(75, t.run("run", "deck.toml", "--out", "out", "--quiet", "--walltime", "1e-9s", *slow(10_000)))
    t.contains(result.err, "stopped after step 0 by the end of its wall time; to go on: ljmd resume out\n")


def second_signal(t):
    """It ends the run at once: here in the middle of saying why it stops, to a pipe that is full."""
    t.deck()
    unread, full = os.pipe()
    os.set_blocking(full, False)
    with contextlib.suppress(BlockingIOError):
        while True:
            os.write(full, b" ")
    os.set_blocking(full, True)
    process = start(t, "run", "deck.toml", "--out", "out", "--quiet", *LONG, stderr=full)
    has_begun(t, process)
    process.send_signal(signal.SIGINT)
    waiting.until(lambda: not signal_is_pending(process, signal.SIGINT), "the first signal is noticed", process)
    process.send_signal(signal.SIGINT)
    t.equal(end(process).code, -signal.SIGINT, "exit code")
    os.close(unread)
    os.close(full)
    t.run_well("resume", "out", "--quiet")
    t.run_well("run", "deck.toml", "--out", "whole", "--quiet", *LONG)
    same_run(t, "out", "whole")


def signal_is_pending(process, number):
    status = pathlib.Path(f"/proc/{process.pid}/status").read_text()
    pending = re.search(r"^ShdPnd:\s*(\w+)$", status, re.MULTILINE)
    return pending is not None and int(pending[1], 16) >> (number - 1) & 1 == 1


def held_and_let_go(t):
    """SIGSTOP and SIGCONT, as `kill` or a laptop's lid give them, leave no trace in the results."""
    t.deck(*OUTPUTS)
    process = start(t, "run", "deck.toml", "--out", "out", "--quiet", *LONG)
    has_begun(t, process)
    process.send_signal(signal.SIGSTOP)
    waiting.until_stopped(process)
    process.send_signal(signal.SIGCONT)
    t.expect(0, end(process))
    t.run_well("run", "deck.toml", "--out", "whole", "--quiet", *LONG)
    same_run(t, "out", "whole")


def ignored_hangup(t):
    """Under nohup a hang-up is not meant."""
    t.deck()
    process = start(t, "run", "deck.toml", "--out", "out", "--quiet", *LONG,
                    preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
    has_begun(t, process)
    process.send_signal(signal.SIGHUP)
    t.expect(0, end(process))


def in_parts(t):
    """A wall time that is over at once: a step a part, and the end is the same."""
    t.deck(*OUTPUTS)
    result = t.expect(75, t.run("run", "deck.toml", "--out", "out", "--walltime", "0.000001s"))
    t.contains(result.err, "stopped after step 0 by the end of its wall time; to go on: ljmd resume out\n")
    parts = 0
    while (code := t.run("resume", "out", "--quiet", "--walltime", "0.000001 s").code) == 75:
        parts += 1
    t.equal(code, 0, "exit code")
    t.check(parts >= 3, f"{parts} parts")
    t.equal(len(t.json("out/run.json")["resumed_at_steps"]), parts + 1, "resumed_at_steps")
    t.run_well("run", "deck.toml", "--out", "whole", "--quiet")
    same_run(t, "out", "whole")


def bodies_in_parts(t):
    t.deck(text=STARS)
    t.expect(75, t.run("run", "deck.toml", "--out", "out", "--walltime", "0.000001s"))
    while (code := t.run("resume", "out", "--quiet", "--walltime", "0.000001 s").code) == 75:
        pass
    t.equal(code, 0, "exit code")
    t.run_well("run", "deck.toml", "--out", "whole", "--quiet")
    same_run(t, "out", "whole")


def longer(t):
    """A finished run is made longer, twice; thermo.csv, the frames and the averages are those of one long run."""
    t.deck(*OUTPUTS)
    t.run_well("run", "deck.toml", "--out", "out", "--quiet")
    t.run_well("resume", "out", "--steps", "+30", "--quiet")
    t.run_well("resume", "out", "--steps", "30", "--quiet")
    t.equal(t.json("out/run.json")["steps_added"], 60, "steps_added")
    t.run_well("run", "deck.toml", "--out", "whole", "--quiet", "--set", "stage.production.steps=100")
    for name in ("thermo.csv", "trajectory.xyz", "rdf.csv", "final.xyz"):
        t.equal(t.read(f"out/{name}"), t.read(f"whole/{name}"), name)
    t.equal(t.json("out/results.json")["observables"], t.json("whole/results.json")["observables"], "observables")
    t.contains(t.run_well("info", "out").out, "after step 120 of 120, 100 of 100 in stage 'production'")


def few_bodies_longer(t):
    """Where the end of a run lies between two rows it has a row of its own, which goes when the run is made longer."""
    t.deck(text=STARS)
    shorter = ("--set", "stage.orbits.steps=33", "--quiet")
    t.run_well("run", "deck.toml", "--out", "out", *shorter)
    t.equal(t.columns("out/thermo.csv")["step"], [0, 10, 20, 30, 33], "steps")
    t.equal(t.json("out/results.json")["observables"]["total_energy"]["at_end"], t.columns("out/thermo.csv")["total_energy"][-1],
            "energy at the end")
    before = run_outputs(t.dir / "out")
    t.run_well("resume", "out", "--quiet")  # finished: nothing is new
    t.equal(run_outputs(t.dir / "out"), before, "files")
    t.run_well("resume", "out", "--steps", "+22", "--quiet")
    t.run_well("run", "deck.toml", "--out", "whole", "--quiet", "--set", "stage.orbits.steps=55")
    for name in ("thermo.csv", "final.xyz", "results.json"):
        found, expected = run_outputs(t.dir / "out")[name], run_outputs(t.dir / "whole")[name]
        t.equal(found, expected, name)


def finished(t):
    """Resuming a run that has come to its end changes nothing."""
    t.deck(*OUTPUTS)
    t.run_well("run", "deck.toml", "--out", "out", "--quiet")
    before = run_outputs(t.dir / "out")
    result = t.run_well("resume", "out")
    t.contains(result.err, "the run was finished after step 60, its results are written anew; to make it longer: "
                           "ljmd resume out --steps +N\n")
    t.check("resuming" not in result.err, "a finished run goes on")
    t.equal(run_outputs(t.dir / "out"), before, "files")


def threads_and_simd(t):
    """What was chosen for the first part is chosen for the next; double precision is the same for all threads."""
    t.deck(*OUTPUTS)
    t.expect(75, t.run("run", "deck.toml", "--out", "out", "--threads", "2", "--simd", "portable", "--walltime", "1e-6 s"))
    t.run_well("resume", "out", "--quiet")
    record = t.json("out/run.json")
    t.equal((record["threads"], record["simd"]), (2, "portable"), "threads and SIMD level")
    t.expect(75, t.run("run", "deck.toml", "--out", "one", "--simd", "portable", "--walltime", "1e-6 s"))
    t.run_well("resume", "one", "--quiet", "--threads", "2")
    t.equal(t.read("one/thermo.csv"), t.read("out/thermo.csv"), "thermo.csv")


def in_use(t):
    """A second run is kept out of a directory, with and without --force, and so is `ljmd resume`.

    The first is halted meanwhile, so that it cannot come to its end: it is there, and has its lock.
    """
    t.deck()
    (t.dir / "out").mkdir()
    descriptor = os.open(t.dir / "out", os.O_RDONLY)
    fcntl.flock(descriptor, fcntl.LOCK_EX)
    texts = ""
    for arguments in (("run", "deck.toml", "--out", "out"), ("run", "deck.toml", "--out", "out", "--force")):
        texts += t.expect(9, t.run(*arguments)).err
    t.equal(t.files("out"), [], "files")
    os.close(descriptor)
    process = start(t, "run", "deck.toml", "--out", "out", *LONG)
    has_begun(t, process)
    process.send_signal(signal.SIGSTOP)
    try:
        texts += t.expect(9, t.run("resume", "out")).err
        texts += t.expect(9, t.run("run", "deck.toml", "--out", "out", "--force")).err
        told = t.run_well("info", "out").out
        t.contains(told, "finished      no, it is running\n")
        t.check("to go on" not in told, "a running run is offered for resuming")
        t.equal(json.loads(t.run_well("info", "out", "--json").out)["running"], True, "running")
    finally:
        process.kill()
    end(process)
    t.run_well("resume", "out", "--quiet")
    t.golden(texts)


def damage(t, path, where=-1):
    """Turn one bit of a file."""
    data = bytearray((t.dir / path).read_bytes())
    data[where] ^= 1
    (t.dir / path).write_bytes(data)


def checkpoints(t, out="out"):
    """Names, the newest last: times of files written in one tick of the clock are the same."""
    def generation(path):
        return struct.unpack_from("<Q", path.read_bytes(), 16)[0]
    names = sorted((t.dir / out).glob("checkpoint.?"), key=generation)
    return [f"{out}/{path.name}" for path in names]


def stopped(t):
    """A run that was stopped before its end, in the directory `out`: at the start, and then after one step."""
    t.deck(*OUTPUTS)
    t.expect(75, t.run("run", "deck.toml", "--out", "out", "--quiet", "--walltime", "1e-6 s"))
    t.expect(75, t.run("resume", "out", "--quiet", "--walltime", "1e-6 s"))


def one_damaged(t):
    """The older generation does, and that is said."""
    t.deck(*OUTPUTS)
    t.run_well("run", "deck.toml", "--out", "out", "--quiet", "--set", "output.checkpoint.every=20")
    t.run_well("run", "deck.toml", "--out", "whole", "--quiet", "--set", "output.checkpoint.every=20")
    damage(t, checkpoints(t)[-1], 100)
    told = t.run_well("info", "out").out
    t.contains(told, "damaged       ")
    t.contains(told, "checkpoint    after step 40 of 60")
    result = t.run_well("resume", "out")
    t.contains(result.err, "warning: ")
    t.contains(result.err, "damaged")
    same_run(t, "out", "whole")


def all_damaged(t):
    stopped(t)
    for name in checkpoints(t):
        damage(t, name, 60)
    before = snapshot(t.dir)
    result = t.expect(6, t.run("resume", "out"))
    t.contains(result.err, "error: no checkpoint can be used\n  out/checkpoint.")
    t.equal(snapshot(t.dir), before, "files")
    t.contains(t.run_well("info", "out").out, "checkpoint    none")


def refused(change, code, *arguments):
    """What is done to a stopped run is noticed before anything is touched."""
    def test(t):
        stopped(t)
        change(t)
        before = snapshot(t.dir)
        result = t.expect(code, t.run("resume", "out", *arguments))
        t.equal(result.out, "", "stdout")
        t.equal(snapshot(t.dir), before, "files")
        # The length of a row goes with the last digits of its numbers, which differ from processor to processor.
        t.golden(re.sub(r"(but had )\d+", r"\1...", result.err))
    return test


def remove(name):
    return lambda t: (t.dir / name).unlink()


def cut(name, length):
    return lambda t: os.truncate(t.dir / name, length)


def no_checkpoints(t):
    for name in checkpoints(t):
        (t.dir / name).unlink()


def another_deck(t):
    record = t.json("out/run.json")
    record["deck"] = record["deck"].replace("0.8442", "0.7")
    (t.dir / "out/run.json").write_text(json.dumps(record))


def given(by, potential, observables, force=None):
    """As if a program had given a run a potential with a table, observables and an external force."""
    def change(t):
        record = t.json("out/run.json")
        table = {"file": "given-potential.json", "error": 1e-9, "force_error": 1e-7} if by == "Python" else None
        record["given"] = {
            "by": by,
            "potential": potential and {"name": potential, "truncation": "cut", "cutoff": 2.5, "switch_start": 0.0,
                                        "checksum": "xxh3:0123456789abcdef", "table": table},
            "observables": [{"name": name, "unit": "sigma/tau", "every": 5, "energy": False} for name in observables],
            "external_force": force}
        (t.dir / "out/run.json").write_text(json.dumps(record))
    return change


def given_is_told(t):
    """`ljmd info` shows what a program gave, and how the run goes on; a table that is lost is said."""
    stopped(t)
    given("Python", None, ["fastest"])(t)
    text = t.run_well("info", "out").out
    t.contains(text, "run with      the observable 'fastest' (every 5 steps, sigma/tau), of a program in Python\n")
    t.contains(text, 'to go on: ljmd.resume("out", observables=[fastest]) in Python\n')
    given("Python", None, [], "wave")(t)
    text = t.run_well("info", "out").out
    t.contains(text, "run with      the external force 'wave', of a program in Python\n")
    t.contains(text, 'to go on: ljmd.resume("out", external=wave) in Python\n')
    given("Python", "soft", [])(t)
    text = t.run_well("info", "out").out
    t.contains(text, "run with      the pair potential 'soft', of a program in Python\n")
    t.contains(text, "damaged       the pair potential 'soft' of this run is not known: out/given-potential.json: no such file\n")


def pipe_for(name):
    def change(t):
        (t.dir / name).unlink()
        os.mkfifo(t.dir / name)
    return change


def link_to_a_copy(name):
    def change(t):
        shutil.move(t.dir / name, t.dir / "elsewhere")
        (t.dir / name).symlink_to(t.dir / "elsewhere")
    return change


def beyond_the_checkpoint(t):
    """What a killed run had written after its last checkpoint is cut off, whatever it is."""
    t.deck(*OUTPUTS)
    t.run_well("run", "deck.toml", "--out", "whole", "--quiet")
    stopped(t)
    for name in ("thermo.csv", "trajectory.xyz"):
        with (t.dir / "out" / name).open("ab") as file:
            file.write(b"half a li")
    t.run_well("resume", "out", "--quiet")
    same_run(t, "out", "whole")


def not_a_run(t):
    (t.dir / "empty").mkdir()
    (t.dir / "other").mkdir()
    (t.dir / "other/run.json").write_text('{"program": "another"}')
    (t.dir / "torn").mkdir()
    (t.dir / "torn/run.json").write_text('{"program": "ljmd", "deck')
    texts = ""
    for name in ("nowhere", "empty", "other", "torn"):
        for command in ("resume", "info"):
            texts += t.expect(3, t.run(command, name)).err
    t.golden(texts)


def told(t):
    """`ljmd info` of a run that was stopped, and what another run into its directory is told."""
    stopped(t)
    text = t.run_well("info", "out").out
    t.contains(text, "out: small\n")
    t.contains(text, "finished      no\n")
    t.contains(text, "checkpoint    after step 16 of 60, 16 of 20 in stage 'melt'\n")
    t.contains(text, "to go on: ljmd resume out\n")
    found = json.loads(t.run_well("info", "out", "--json").out)
    t.equal(found["checkpoint"], {"step": 16, "stage": "melt", "atoms": 108}, "checkpoint")
    t.equal((found["finished"], found["running"], found["total_steps"]), (False, False, 60), "what it tells")
    t.golden(t.expect(2, t.run("run", "deck.toml", "--out", "out")).err)


def usage(*arguments):
    def test(t):
        t.deck()
        result = t.expect(2, t.run(*arguments))
        t.equal(t.files(), ["deck.toml"], "files")
        t.golden(result.err)
    return test


def moved(t):
    """A directory that was moved elsewhere goes on there."""
    t.deck(*OUTPUTS)
    t.run_well("run", "deck.toml", "--out", "whole", "--quiet")
    stopped(t)
    (t.dir / "far").mkdir()
    shutil.move(t.dir / "out", t.dir / "far/away")
    (t.dir / "deck.toml").unlink()
    t.run_well("resume", "far/away", "--quiet")
    same_run(t, "far/away", "whole")


def cases():
    return [
        Case("SIGTERM", stopped_by(signal.SIGTERM)),
        Case("SIGINT", stopped_by(signal.SIGINT)),
        Case("SIGHUP", stopped_by(signal.SIGHUP)),
        Case("SIGUSR1", stopped_by(signal.SIGUSR1)),
        Case("SIGXCPU", stopped_by(signal.SIGXCPU)),
        Case("stopped while the start is made", stopped_while_the_start_is_made),
        Case("a second SIGINT", second_signal),
        Case("SIGSTOP and SIGCONT", held_and_let_go),
        Case("SIGHUP under nohup", ignored_hangup),
        Case("in parts of a wall time", in_parts),
        Case("a few bodies in parts of a wall time", bodies_in_parts),
        Case("made longer", longer), Case("few bodies made longer", few_bodies_longer),
        Case("finished before", finished),
        Case("threads and SIMD level as before", threads_and_simd),
        Case("a directory in use", in_use),
        Case("one checkpoint damaged", one_damaged),
        Case("all checkpoints damaged", all_damaged),
        Case("no checkpoint", refused(no_checkpoints, 6)),
        Case("a checkpoint of another deck", refused(another_deck, 6)),
        Case("a potential and observables of Python", refused(given("Python", "soft", ["fastest", "slowest"]), 6)),
        Case("a potential of C++", refused(given("C++", "soft", []), 6)),
        Case("an external force of Python", refused(given("Python", None, [], "wave"), 6)),
        Case("what a program gave", given_is_told),
        Case("thermo.csv shorter than it was", refused(cut("out/thermo.csv", 100), 6)),
        Case("thermo.csv gone", refused(remove("out/thermo.csv"), 6)),
        Case("thermo.csv replaced by a pipe", refused(pipe_for("out/thermo.csv"), 6)),
        Case("thermo.csv replaced by a link", refused(link_to_a_copy("out/thermo.csv"), 6)),
        Case("trajectory shorter than it was", refused(cut("out/trajectory.xyz", 10), 6)),
        Case("trajectory gone", refused(remove("out/trajectory.xyz"), 6)),
        Case("too many steps more", refused(lambda t: None, 2, "--steps", "+9000000000000000000")),
        Case("files longer than they were", beyond_the_checkpoint),
        Case("not the directory of a run", not_a_run),
        Case("what a directory holds", told),
        Case("a wall time that is none", usage("run", "deck.toml", "--out", "out", "--walltime", "soon")),
        Case("no steps more", usage("resume", "out", "--steps", "0")),
        Case("a checkpoint interval that is none",
             usage("check", "deck.toml", "--set", "output.checkpoint.every=\"often\"")),
        Case("a checkpoint interval of no steps", usage("check", "deck.toml", "--set", "output.checkpoint.every=0")),
        Case("more generations than can be kept", usage("check", "deck.toml", "--set", "output.checkpoint.keep=100")),
        Case("a directory that was moved", moved),
    ]
