"""Runs that end when an error is reached, and replicas of one deck: what they say and write, stopped and resumed."""

import json
import signal

from harness import Case, check_same_run, snapshot
from resumes import end, start
import waiting

# A gas under friction and noise: its kinetic energy is soon drawn anew, so that hundreds of steps have an error.
QUICK = (("density = 0.8442", "density = 0.05"), ("steps = 40\nsample = true",
         'until = { temperature = 0.02, max_steps = 20000 }\nsample = true\nthermostat = { type = "langevin", time = 0.01 }'),
         ("thermo = { every = 5 }", "thermo = { every = 1 }"))
MELT = 20
LOOKS = (128, 182, 256, 363, 512, 725, 1024, 1449)


def ran(t, *arguments, out="whole"):
    t.run_well("run", "deck.toml", "--out", out, "--quiet", *arguments)
    return t.json(f"{out}/results.json")


def steps_of(results):
    return results["stages"][-1]["steps"]


def an_error_ends_a_stage(t):
    t.deck(*QUICK)
    result = t.run_well("run", "deck.toml", "--out", "out")
    t.contains(result.err, "stage 'production': until errors are reached, at most 20000 steps of 0.004 tau\n")
    found = t.json("out/results.json")
    until = found["stages"][-1]["until"]
    steps = steps_of(found)
    t.check(steps in LOOKS, f"{steps} steps are at no look")
    t.contains(result.out, f"stage 'production' reached the errors wanted: it took {steps} of at most 20000\n")
    t.equal((until["reached"], until["max_steps"], until["wanted"]), (True, 20000, {"temperature": 0.02}), "until")
    t.check(until["errors"]["temperature"] <= 0.02, f"error {until['errors']}")
    t.equal(found["observables"]["temperature"]["standard_error"], until["errors"]["temperature"], "its error")
    t.check(not any("errors wanted" in doubt for doubt in found["doubts"]), f"doubts: {found['doubts']}")
    record = t.json("out/run.json")
    t.equal((record["until_reached"], record["steps_taken"]), (True, steps + MELT), "record")
    info = json.loads(t.run_well("info", "out", "--json").out)
    t.equal((info["finished"], info["total_steps"], info["total_steps_are_most"]), (True, steps + MELT, False), "info")
    t.equal(len(t.columns("out/thermo.csv")["step"]), steps + MELT + 1, "rows of thermo.csv")


def max_steps_come_first(t):
    t.deck(*QUICK)
    result = t.run_well("run", "deck.toml", "--out", "out", "--set", "stage.production.until.temperature=1e-4",
                        "--set", "stage.production.until.max_steps=300")
    found = t.json("out/results.json")
    t.equal((steps_of(found), found["stages"][-1]["until"]["reached"]), (300, False), "until")
    t.contains(result.err, "warning: stage 'production' ended at its max_steps, 300, before it reached the errors wanted: temperature ")
    t.check(any("max_steps, 300" in doubt for doubt in found["doubts"]), f"doubts: {found['doubts']}")
    t.equal(t.json("out/run.json")["until_reached"], False, "record")
    t.contains(t.read("out/results.txt"), "ended at its max_steps")
    # More steps go on until the error is reached: a smaller one is out of reach, the same run is longer.
    t.run_well("resume", "out", "--steps", "+200", "--quiet")
    t.equal(steps_of(t.json("out/results.json")), 500, "steps")
    ran(t, "--set", "stage.production.until.temperature=1e-4", "--set", "stage.production.until.max_steps=500")
    t.equal(t.read("out/thermo.csv"), t.read("whole/thermo.csv"), "thermo.csv")


def stopped_at_every_look(t):
    """And beside it; and after the last: the run ends at the same step, with the same bytes."""
    t.deck(*QUICK)
    steps = steps_of(ran(t))
    stops = [look + more for look in LOOKS if look <= steps for more in (-1, 0, 1) if look + more <= steps]
    for stop in (1, *stops):
        step = stop + MELT
        t.run_well("run", "deck.toml", "--out", "part", "--quiet", "--force", "--set", f"output.checkpoint.every={step}",
                   "--set", f"stage.production.until.max_steps={stop}")
        record = t.json("part/run.json")
        # The same run with a later end: what a stopped run is.
        t.equal(record["steps_taken"], step, "steps taken")
        if record["until_reached"]:  # the end at max_steps is looked at, too
            t.check(stop > steps / 1.5, f"the error was reached after {stop} steps already, and at looks after {steps}")
            continue
        t.run_well("resume", "part", "--steps", f"+{20000 - stop}", "--quiet")
        t.equal(t.read("part/thermo.csv"), t.read("whole/thermo.csv"), f"thermo.csv, stopped after step {stop}")
        t.equal(t.read("part/final.xyz"), t.read("whole/final.xyz"), f"final.xyz, stopped after step {stop}")
        t.equal(t.json("part/results.json"), t.json("whole/results.json"), f"results, stopped after step {stop}")


def killed_and_resumed(t):
    t.deck(*QUICK)
    long = ("--set", "stage.production.until.temperature=0.002", "--set", "stage.production.until.max_steps=1000000")
    process = start(t, "run", "deck.toml", "--out", "out", "--set", "output.checkpoint.every=100", *long)
    waiting.until(lambda: (t.dir / "out/thermo.csv").exists() and (t.dir / "out/thermo.csv").stat().st_size > 100000,
                  "its first rows", process)
    process.send_signal(signal.SIGKILL)
    end(process)
    text = t.run_well("info", "out").out
    t.contains(text, " of at most 1000020, ")
    again = t.run_well("resume", "out")
    t.contains(again.err, " of at most 1000020\n")
    ran(t, "--set", "output.checkpoint.every=100", *long)
    check_same_run(t.dir / "out", t.dir / "whole")
    # A finished run writes its results anew, and no other.
    before = t.read("out/results.json")
    t.contains(t.run_well("resume", "out").err, "the run was finished after step")
    t.equal(t.read("out/results.json"), before, "results written anew")


def a_reached_run_is_extended(t):
    """By the steps asked for, whatever its errors; interrupted and resumed as well."""
    t.deck(*QUICK)
    steps = steps_of(ran(t, out="out"))
    t.run_well("resume", "out", "--steps", "+50", "--quiet")
    found = t.json("out/results.json")
    t.equal((steps_of(found), found["stages"][-1]["until"]["reached"]), (steps + 50, True), "until")
    t.equal(t.json("out/run.json")["last_stage_steps"], steps + 50, "last_stage_steps")
    t.run_well("resume", "out", "--steps", "+30", "--quiet")
    t.equal(steps_of(t.json("out/results.json")), steps + 80, "steps")
    t.run_well("resume", "out", "--quiet")
    t.equal(steps_of(t.json("out/results.json")), steps + 80, "steps of a finished run")
    t.equal(len(t.columns("out/thermo.csv")["step"]), MELT + steps + 81, "rows of thermo.csv")


def what_a_run_would_cost_at_most(t):
    t.deck(*QUICK)
    text = t.run_well("check", "deck.toml").out
    t.contains(text, "'production': at most 20000 steps of 0.004 tau = 80 tau, sampled")
    t.contains(text, "  time      at most about ")
    t.contains(text, "  disk      at most about ")
    found = json.loads(t.run_well("check", "deck.toml", "--json").out)
    t.equal((found["steps"], found["steps_are_most"]), (20020, True), "steps")


def exported(t):
    t.deck(*QUICK)
    result = t.run_well("export", "deck.toml", "--to", "lammps", "--out", "lmp", "--quiet")
    found = json.loads(t.run_well("export", "deck.toml", "--to", "lammps", "--out", "lmp", "--force", "--json").out)
    t.check(any("ends when errors are reached; exported are its max_steps, 20000" in text for text in found["warnings"]),
            f"warnings: {found['warnings']}")
    t.contains(t.read("lmp/in.lammps"), "variable steps index 20000\n")
    t.equal(result.code, 0, "exit code")


def refused(*replacements, settings=()):
    def test(t):
        t.deck(*replacements)
        before = snapshot(t.dir)
        result = t.expect(2, t.run("check", "deck.toml", *settings))
        t.golden(result.err)
        t.equal(snapshot(t.dir), before, "files")
    return test


UNTIL = QUICK[1]


def with_until(text):
    return (UNTIL[0], UNTIL[1].replace("temperature = 0.02, max_steps = 20000", text))


def few_bodies_are_refused(t):
    t.run_well("init", "few.toml", "--example", "kepler-leapfrog")
    text = t.read("few.toml").replace("[[stage]]\n", "[[stage]]\nuntil = { pressure = 0.1, max_steps = 100 }\n", 1)
    (t.dir / "few.toml").write_text(text, encoding="utf-8")
    t.contains(t.expect(2, t.run("check", "few.toml")).err,
               "'until' in [[stage]] is for fluids: a motion of few bodies has no averages with errors")


def replicas(t):
    t.deck(("steps = 40", "steps = 400"))
    result = t.run_well("run", "deck.toml", "--out", "out", "--replicas", "3", "--jobs", "2")
    t.contains(result.out, "3 replicas, merged")
    merged = t.json("out/results.json")
    members = [t.json(f"out/points/replica-{k}/results.json")["observables"]["pressure"] for k in (1, 2, 3)]
    pressure = merged["observables"]["pressure"]
    mean = sum(each["mean"] for each in members) / 3
    t.check(abs(pressure["mean"] - mean) < 1e-12, f"mean {pressure['mean']}, not {mean}")
    t.equal(len({each["mean"] for each in members}), 3, "different runs")
    t.equal(merged["replicas"], 3, "replicas")
    t.equal([t.json(f"out/points/replica-{k}/run.json")["seed"] for k in (1, 2, 3)], merged["seeds"], "seeds")
    t.equal(t.read("out/results.txt"), result.out, "results.txt")
    about = json.loads(t.run_well("info", "out", "--json").out)
    t.equal((about["kind"], about["states"]["finished"]), ("replicas", 3), "info")
    # Nothing is left to do, and the same is written.
    before = t.read("out/results.json")
    again = t.run_well("run", "deck.toml", "--out", "out", "--replicas", "3")
    t.equal(again.out, result.out, "the same results")
    t.run_well("resume", "out")
    t.equal(t.read("out/results.json"), before, "results.json")
    # Longer.
    t.run_well("resume", "out", "--steps", "+100", "--jobs", "1")
    for k in (1, 2, 3):
        t.equal(steps_of(t.json(f"out/points/replica-{k}/results.json")), 500, f"steps of replica {k}")
    t.run_well("resume", "out")
    t.equal(steps_of(t.json("out/points/replica-1/results.json")), 500, "steps are added once")
    report = json.loads(t.run_well("report", "out", "--json").out)
    t.equal(report["state"], "finished", "report")


def replicas_until_an_error(t):
    """Each to its error times sqrt(n), so that the merged one is that wanted."""
    t.deck(*QUICK)
    t.run_well("run", "deck.toml", "--out", "out", "--replicas", "4", "--quiet", "--set", "stage.production.until.temperature=0.01")
    merged = t.json("out/results.json")["observables"]["temperature"]
    for k in (1, 2, 3, 4):
        until = t.json(f"out/points/replica-{k}/results.json")["stages"][-1]["until"]
        t.equal((until["wanted"]["temperature"], until["reached"]), (0.02, True), f"replica {k}")
    t.check(merged["standard_error_within"] <= 0.01, f"merged {merged}")


def replicas_that_were_killed(t):
    t.deck(("steps = 40", "steps = 20000"), ("thermo = { every = 5 }", "thermo = { every = 5 }\ncheckpoint = { every = 200 }"))
    process = start(t, "run", "deck.toml", "--out", "out", "--replicas", "2", "--jobs", "2")
    waiting.until(lambda: all((t.dir / f"out/points/replica-{k}/checkpoint.1").exists() for k in (1, 2)), "checkpoints", process)
    process.send_signal(signal.SIGKILL)
    end(process)
    t.run_well("resume", "out", "--quiet")
    t.run_well("run", "deck.toml", "--out", "whole", "--replicas", "2", "--quiet")
    for k in (1, 2):
        for name in ("thermo.csv", "final.xyz", "results.json"):
            t.equal(t.read(f"out/points/replica-{k}/{name}"), t.read(f"whole/points/replica-{k}/{name}"), f"{name} of replica {k}")
    t.equal(t.json("out/results.json"), t.json("whole/results.json"), "merged results")


def replicas_that_are_refused(t):
    t.deck()
    t.run_well("run", "deck.toml", "--out", "run", "--quiet")
    t.contains(t.expect(2, t.run("run", "deck.toml", "--out", "run", "--replicas", "2")).err, "is the directory of a run")
    text = (t.dir / "deck.toml").read_text(encoding="utf-8").replace('lattice = { type = "fcc", cells = 3 }\n', 'file = "run/final.xyz"\n')
    text = text.replace("density = 0.8442\n", "").replace('thermostat = { type = "rescale", every = 5 }\n', "")
    (t.dir / "same.toml").write_text(text, encoding="utf-8")
    result = t.expect(2, t.run("run", "same.toml", "--out", "same", "--replicas", "2"))
    t.contains(result.err, "all replicas would be the same run")
    t.check(not (t.dir / "same").exists(), "a directory was made")


def cases():
    return [
        Case("an error ends a stage", an_error_ends_a_stage),
        Case("max_steps come first", max_steps_come_first),
        Case("stopped at every look", stopped_at_every_look),
        Case("killed and resumed", killed_and_resumed),
        Case("a reached run is extended", a_reached_run_is_extended),
        Case("what it costs at most", what_a_run_would_cost_at_most),
        Case("exported", exported),
        Case("without max_steps", refused(QUICK[0], with_until("temperature = 0.02"))),
        Case("without an error", refused(QUICK[0], with_until("max_steps = 100"))),
        Case("an unknown observable", refused(QUICK[0], with_until("presure = 0.02, max_steps = 100"))),
        Case("an error of zero", refused(QUICK[0], with_until("pressure = 0, max_steps = 100"))),
        Case("a constant density", refused(QUICK[0], with_until("density = 0.1, max_steps = 100"))),
        Case("beside steps", refused(QUICK[0], ("steps = 40", "steps = 40\nuntil = { pressure = 0.1, max_steps = 100 }"))),
        Case("neither steps nor until", refused(("steps = 40\n", ""))),
        Case("not sampled", refused(QUICK[0], (UNTIL[0], UNTIL[1].replace("sample = true\n", "")))),
        Case("not the last stage", refused(("steps = 20", "until = { pressure = 0.1, max_steps = 100 }\nsample = true"))),
        Case("few bodies", few_bodies_are_refused),
        Case("replicas", replicas),
        Case("replicas until an error is reached", replicas_until_an_error),
        Case("replicas that were killed", replicas_that_were_killed),
        Case("replicas that are refused", replicas_that_are_refused),
    ]
