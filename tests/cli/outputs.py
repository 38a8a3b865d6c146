"""What a run writes, and what it leaves alone."""

import json
import math
import os
import re
import signal
import subprocess

from harness import ARGON, DECK, STARS, Case, clean_environment, snapshot
import waiting

SUBSTANCE = DECK.replace("[system]", ARGON + "\n[system]")
ALL_OUTPUTS = ('thermo = { every = 5 }',
               'thermo = { every = 5 }\ntrajectory = { format = "xyz", every = 10, velocities = true }\n\n'
               '[analysis]\nrdf = { bins = 50, every = 10 }')
THERMO = "step,time,temperature,potential_energy,kinetic_energy,total_energy,pressure"
OBSERVABLES = ["temperature", "potential_energy", "kinetic_energy", "total_energy", "pressure", "compressibility_factor"]


def run_all(t, *arguments, text=DECK, out="out"):
    t.deck(ALL_OUTPUTS, text=text)
    return t.run_well("run", "deck.toml", "--out", out, *arguments)


def files_written(t):
    run_all(t)
    found = set(t.files("out"))
    wanted = {"run.json", "results.json", "results.txt", "thermo.csv", "final.xyz", "trajectory.xyz", "rdf.csv",
              "sk_from_rdf.csv", "checkpoint.1", "checkpoint.2"}
    t.equal(found, wanted, "files")
    t.equal(sorted(p.name for p in t.dir.iterdir()), ["deck.toml", "out"], "files beside the output directory")


def h5md_is_the_default(t):
    t.deck(('thermo = { every = 5 }', 'trajectory = { every = 10 }'))
    t.run_well("run", "deck.toml", "--quiet")
    data = (t.dir / "runs/deck/trajectory.h5md").read_bytes()
    t.check(data.startswith(b"\x89HDF\r\n\x1a\n"), "trajectory.h5md is no HDF5 file")


def default_directory(t):
    t.deck(name="my deck.toml")
    t.run_well("run", "my deck.toml", "--quiet")
    t.check((t.dir / "runs/my deck/results.json").exists(), f"files: {t.files()}")


def directory_of_the_deck(t):
    t.deck(("[output]", '[output]\ndirectory = "here/and/there"'))
    result = t.run_well("run", "deck.toml", "--quiet")
    t.check((t.dir / "here/and/there/results.json").exists(), f"files: {t.files()}")
    t.contains(result.out, "files: here/and/there\n")


def thermo_csv(t):
    run_all(t)
    header = t.read("out/thermo.csv").split("\n", 1)[0]
    t.check(header.startswith(THERMO), f"header: {header}")
    columns = t.columns("out/thermo.csv")
    t.equal(columns["step"], [5.0 * k for k in range(13)], "steps")
    for k, time in enumerate(columns["time"]):
        t.check(abs(time - 0.02 * k) < 1e-12, f"time {time} at step {5 * k}")
    for u, kinetic, total in zip(columns["potential_energy"], columns["kinetic_energy"], columns["total_energy"]):
        t.check(abs(u + kinetic - total) < 1e-12, "total_energy is not the sum")
    for temperature, kinetic in zip(columns["temperature"], columns["kinetic_energy"]):
        t.check(abs(temperature - 2 * kinetic * 108 / (3 * 107)) < 1e-12, "temperature does not fit the kinetic energy")
    t.check(abs(columns["temperature"][0] - 1.0) < 1e-12, "the start does not have the deck's temperature")


def si_columns(t):
    run_all(t, text=SUBSTANCE)
    columns = t.columns("out/thermo.csv")
    for reduced, si, factor in (("temperature", "temperature_K", 119.8), ("time", "time_ps", 2.1563494),
                                ("pressure", "pressure_bar", 418.976), ("total_energy", "total_energy_kJ_per_mol", 0.996073)):
        for a, b in zip(columns[reduced], columns[si]):
            t.check(abs(factor * a - b) < 2e-5 * (1 + abs(b)), f"{si}: {b}, but {reduced} is {a}")
    rdf = t.columns("out/rdf.csv")
    t.check(all(abs(0.3405 * a - b) < 1e-12 for a, b in zip(rdf["r"], rdf["r_nm"])), "r_nm")
    t.equal(t.json("out/results.json")["observables"]["pressure"]["si"]["unit"], "bar", "SI unit of the pressure")


def rdf_csv(t):
    run_all(t)
    t.check(t.read("out/rdf.csv").startswith("r,g,g_standard_error"), "header of rdf.csv")
    columns = t.columns("out/rdf.csv")
    t.equal(len(columns["r"]), 50, "bins")
    t.equal(columns["g"][0], 0.0, "g near r = 0")
    t.check(max(columns["g"]) > 2, "g has no peak")


def results_json(t):
    run_all(t)
    found = t.json("out/results.json")
    for name in OBSERVABLES:
        values = found["observables"][name]
        for key in ("mean", "standard_error", "independent_samples"):
            t.check(values[key] is None or math.isfinite(values[key]), f"{name} {key}: {values[key]}")
        t.check(isinstance(values["mean"], float), f"{name} has no mean")
        t.check(isinstance(values["unit"], str) and values["unit"], f"{name} has no unit")
    rows = t.columns("out/thermo.csv")
    sampled = [u for step, u in zip(rows["step"], rows["potential_energy"]) if step > 20]
    mean = sum(sampled) / len(sampled)
    t.check(abs(found["observables"]["potential_energy"]["mean"] - mean) < 1e-12, "the mean is not that of thermo.csv")
    t.equal([(s["name"], s["steps"]) for s in found["stages"]], [("melt", 20), ("production", 40)], "stages")
    t.equal(found["stages"][0]["energy_drift"], None, "drift under a thermostat")
    t.check(abs(found["stages"][1]["energy_drift"]) < 1, "drift at constant energy")


def run_json(t):
    run_all(t, "--set", "system.seed=11")
    found = t.json("out/run.json")
    t.equal(found["deck"], (t.dir / "deck.toml").read_text(), "deck")
    t.equal(found["settings"], ["system.seed=11"], "settings")
    t.equal(found["seed"], 11, "seed")
    t.equal(found["finished"], True, "finished")
    t.equal(found["resumed_at_steps"], [], "resumed_at_steps")
    for key in ("version", "commit", "compiler", "simd", "threads", "host", "deck_hash", "began", "ended"):
        t.check(found.get(key) is not None, f"run.json has no {key}")
    t.check(re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ", found["began"]), f"began: {found['began']}")


def hash_tells_decks_apart(t):
    hashes = set()
    for out, arguments in (("a", []), ("b", []), ("c", ["--set", "system.seed=8"])):
        t.deck()
        t.run_well("run", "deck.toml", "--quiet", "--out", out, *arguments)
        hashes.add(t.json(f"{out}/run.json")["deck_hash"])
    t.equal(len(hashes), 2, "different hashes of two equal decks and one with a --set")


def final_xyz(t):
    run_all(t)
    lines = t.read("out/final.xyz").splitlines()
    t.equal(lines[0], "108", "first line")
    t.contains(lines[1], "Properties=species:S:1:pos:R:3:velo:R:3:momenta:R:3:id:I:1")
    t.contains(lines[1], 'pbc="T T T"')
    t.contains(lines[1], "step=60")
    t.equal([int(line.split()[10]) for line in lines[2:]], list(range(1, 109)), "ids")


def trajectory_xyz(t):
    run_all(t)
    lines = t.read("out/trajectory.xyz").splitlines()
    t.equal([line for line in lines[::110]], ["108"] * 7, "first lines of the frames")
    t.equal([re.search(r"step=(\d+)", line).group(1) for line in lines[1::110]],
            [str(step) for step in range(0, 61, 10)], "steps")
    t.equal(lines[-108:], t.read("out/final.xyz").splitlines()[2:], "the last frame is not final.xyz")


def existing_run_is_refused(t):
    run_all(t)
    (t.dir / "out/notes.txt").write_text("mine")
    before = snapshot(t.dir / "out")
    result = t.expect(2, t.run("run", "deck.toml", "--out", "out"))
    t.equal(result.out, "", "stdout")
    t.golden(result.err)
    t.equal(snapshot(t.dir / "out"), before, "files after the refusal")


def force_replaces_its_own_files_only(t):
    run_all(t)
    (t.dir / "out/notes.txt").write_text("mine")
    (t.dir / "out/start.xyz").write_text("mine too")
    (t.dir / "elsewhere.csv").write_text("not to be followed")
    (t.dir / "out/thermo.csv").unlink()
    (t.dir / "out/thermo.csv").symlink_to(t.dir / "elsewhere.csv")
    t.deck(("steps = 40", "steps = 20"))  # neither trajectory nor rdf
    t.run_well("run", "deck.toml", "--out", "out", "--force", "--quiet")
    t.equal(t.read("out/notes.txt"), "mine", "notes.txt")
    t.equal(t.read("out/start.xyz"), "mine too", "start.xyz")
    t.equal(t.read("elsewhere.csv"), "not to be followed", "the file that a link led to")
    for name in ("trajectory.xyz", "rdf.csv", "sk_from_rdf.csv"):
        t.check(not (t.dir / "out" / name).exists(), f"{name} of the earlier run is still there")
    t.equal(t.columns("out/thermo.csv")["step"][-1], 40.0, "last step")


def a_refused_deck_costs_nothing(t):
    """Even with --force, an earlier run outlives a deck or a start that cannot be used."""
    run_all(t)
    before = snapshot(t.dir / "out")
    t.expect(2, t.run("run", "deck.toml", "--out", "out", "--force", "--set", "system.density=-1"))
    (t.dir / "bad.xyz").write_text("two atoms\n")
    start = DECK.replace('lattice = { type = "fcc", cells = 3 }\n', 'file = "bad.xyz"\n')
    t.deck(text=start, name="start.toml")
    t.expect(3, t.run("run", "start.toml", "--out", "out", "--force"))
    t.equal(snapshot(t.dir / "out"), before, "the earlier run")


def the_start_is_not_replaced(t):
    run_all(t)
    before = snapshot(t.dir / "out")
    for file in ("out", "out/final.xyz", "./out/../out/final.xyz", "out/trajectory.xyz"):
        t.deck(('lattice = { type = "fcc", cells = 3 }\n', f'file = "{file}"\n'), name="next.toml")
        result = t.expect(2, t.run("run", "next.toml", "--out", "out", "--force"))
        t.contains(result.err, "is read, and would be replaced by what is written. Nothing was run.\n")
        t.equal(snapshot(t.dir / "out"), before, "files after the refusal")
    t.golden(result.err)


def the_deck_is_not_replaced(t):
    (t.dir / "out").mkdir()
    t.deck(name="out/thermo.csv")
    before = snapshot(t.dir)
    for path in ("out/thermo.csv", "./out/../out/thermo.csv"):
        result = t.expect(2, t.run("run", path, "--out", "out", "--force"))
        t.equal(result.err.splitlines()[0], f"error: {path} is read, and would be replaced by what is written. Nothing was run.",
                "stderr")
        t.equal(snapshot(t.dir), before, "files after the refusal")


def processor_time(times):
    """Of the processes that have ended, in seconds."""
    return times.children_user + times.children_system


def a_run_that_ends_meanwhile_is_not_replaced(t):
    """A start that takes long is made before the directory is taken; what comes to lie there until then is kept."""
    t.deck()
    before = os.times()
    t.run_well("run", "deck.toml", "--out", "like-it", "--quiet")
    small_run = processor_time(os.times()) - processor_time(before)
    slow = subprocess.Popen([t.ljmd, "run", "deck.toml", "--out", "out", "--quiet", "--set",
                             'system.lattice={type="random",atoms=60000}', "--set", "stage.melt.steps=1", "--set",
                             "stage.production.steps=1"], cwd=t.dir, env=clean_environment(), stdin=subprocess.DEVNULL,
                            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    try:
        # By then it has read its deck and looked at the directory, and is far from having placed its atoms.
        waiting.until_used(slow, small_run + 0.05)
        slow.send_signal(signal.SIGSTOP)
        t.run_well("run", "deck.toml", "--out", "out", "--quiet")
        slow.send_signal(signal.SIGCONT)
        _, error = slow.communicate(timeout=waiting.PATIENCE)
    finally:
        slow.kill()
    t.equal(slow.returncode, 2, "exit code")
    t.contains(error.decode(), "error: out already holds a run (run.json). Nothing was run.\n")
    t.equal(t.json("out/results.json")["system"]["atoms"], 108, "atoms of the run that is there")


def output_is_a_file(t):
    t.deck()
    (t.dir / "taken").write_text("mine")
    t.golden(t.expect(2, t.run("run", "deck.toml", "--out", "taken")).err)
    t.equal(t.read("taken"), "mine", "the file")


def json_on_stdout(t):
    result = run_all(t, "--json", "--quiet")
    t.equal(json.loads(result.out), t.json("out/results.json"), "stdout with --json")
    t.equal(result.out, t.read("out/results.json"), "bytes of stdout with --json")


def a_stopped_run_is_to_be_resumed(t):
    """A run that has not come to its end is there: what is suggested first is to resume it."""
    t.deck()
    t.expect(75, t.run("run", "deck.toml", "--out", "out", "--walltime", "1e-6 s"))
    result = t.expect(2, t.run("run", "deck.toml", "--out", "out"))
    t.golden(result.err)
    t.run_well("resume", "out")


def table_on_stdout(t):
    """The table holds nothing but results; numbers are left out of the golden file."""
    result = run_all(t, "--quiet", text=SUBSTANCE)
    t.equal(result.out, t.read("out/results.txt"), "stdout")
    t.golden(re.sub(r" +", " ", re.sub(r"-?\d+(\.\d+)?(e[-+]\d+)?", "#", result.out)))


def a_title_cannot_play_tricks(t):
    t.deck(('title = "small"', 'title = "\\u001b[31mred\\u0007"'))
    result = t.run_well("run", "deck.toml")
    t.check("\x1b" not in result.out + result.err and "\x07" not in result.out, "a control character reaches the terminal")


def same_deck_same_bytes(t):
    for out in ("a", "b"):
        run_all(t, out=out)
    for name in ("thermo.csv", "final.xyz", "trajectory.xyz", "rdf.csv", "results.json"):
        t.check((t.dir / "a" / name).read_bytes() == (t.dir / "b" / name).read_bytes(), f"{name} differs")


def output_does_not_disturb(t):
    """How often something is written or measured changes no bit of the trajectory."""
    finals = set()
    for out, replacement in (("a", "thermo = { every = 5 }"), ("b", "thermo = { every = 1 }"), ("c", "thermo = { every = 1000 }"),
                             ("d", "trajectory = { every = 3 }"), ("e", ALL_OUTPUTS[1])):
        t.deck(("thermo = { every = 5 }", replacement))
        t.run_well("run", "deck.toml", "--quiet", "--out", out)
        finals.add(t.read(f"{out}/final.xyz"))
    t.equal(len(finals), 1, "different last configurations")


def another_seed_is_another_run(t):
    finals = set()
    for seed in (1, 2):
        t.deck(("seed = 7", f"seed = {seed}"))
        t.run_well("run", "deck.toml", "--quiet", "--out", str(seed))
        finals.add(t.read(f"{seed}/final.xyz"))
    t.equal(len(finals), 2, "different last configurations")


def commands_can_be_copied(t):
    """A shell takes each command that is printed for what it is meant to be, whatever the names are."""
    name, deck = "it's a $HOME; test", "a deck & more.toml"
    (t.dir / "bin").mkdir()
    (t.dir / "bin/ljmd").symlink_to(t.ljmd)
    environment = {**clean_environment(), "PATH": f"{t.dir}/bin:{os.environ['PATH']}", "HOME": "elsewhere"}

    def copied(text, pattern, *replacements, code=0):
        """Run what the group of the pattern matches."""
        found = re.search(pattern, text)
        t.check(found, f"{pattern!r} is not in:\n{text}")
        command = found.group(1)
        for old, new in replacements:
            t.contains(command, old)
            command = command.replace(old, new)
        return t.expect(code, t.command(["/bin/sh", "-c", command], env=environment))

    made = t.run_well("init", deck)
    copied(made.out, "to see what it costs: (.*)")
    t.contains(made.out, "to run it: ljmd run 'a deck & more.toml'\n")
    t.deck(name=deck)
    request = ("run", deck, "--out", name, "--quiet")
    stopped = t.expect(75, t.run(*request, "--walltime", "0.000001s"))
    t.contains(copied(t.run_well("info", name).out, "to go on: (.*)", ("resume", "info")).out, "to go on: ")
    copied(t.expect(2, t.run(*request)).err, "resume it: (.*), or choose", ("resume", "info"))
    copied(stopped.err, "to go on: (.*)")
    copied(t.run_well("resume", name).err, "to make it longer: (.*)", ("+N", "+10"))
    t.contains(t.run_well("info", name).out, "70")
    copied(t.run_well("export", deck, "--to", "lammps", "--out", f"{name} 1").out, "(cd .*)", ("lmp -in", "ls"))
    sweep = ("sweep", deck, "--grid", "system.temperature=1|2", "--out", f"{name} 2")
    copied(t.run_well(*sweep, "--prepare").out, "to run them: (.*)", ("K/T", "1/1"))
    copied(t.run_well(*sweep, "--quiet").out, "to draw them: (.*)", ("plot", "info"))
    copied(t.expect(3, t.run("analyze", f"{name} 2")).err, "`(ljmd report .*?)` shows it")
    t.run_well("run", deck, "--replicas", "2", "--out", f"{name} 3", "--quiet")
    (t.dir / f"{name} 3/points/replica-1/run.json").unlink()
    copied(t.run_well("info", f"{name} 3").out, "to go on: (.*)")
    failing = t.expect(5, t.run("run", deck, "--replicas", "2", "--out", f"{name} 4", "--quiet", "--force",
                                "--set", "stage.production.time_step=0.4"))
    copied(failing.err, "to try them again: (.*)", code=5)


def few_bodies(t):
    """A few-body run there and back on integer positions: all its files, and the checksum it began with."""
    stage = 'integrator = "bit-reversible"\n'
    t.deck(("steps = 100", "steps = 100\n" + stage),
           ("[output]", '[[stage]]\nname = "back"\ntime_step = 0.01\nsteps = 100\nreverse = true\nsample = false\n' + stage +
            "\n[analysis]\norbit = { body = 2, about = 1 }\n\n[output]\ntrajectory = { every = 20 }"), text=STARS)
    printed = t.run_well("run", "deck.toml", "--quiet", "--out", "out").out
    t.equal(t.files("out"), ["checkpoint.1", "checkpoint.2", "final.xyz", "orbit.csv", "results.json", "results.txt",
                             "run.json", "thermo.csv", "trajectory.csv"], "files")
    t.equal(t.read("out/results.txt"), printed, "results.txt")
    stages = t.json("out/results.json")["stages"]
    t.equal(stages[1]["checksum_at_end"], stages[0]["checksum_at_start"], "checksum")
    t.check(stages[0]["checksum_at_end"] != stages[0]["checksum_at_start"], "nothing moved")
    path = t.columns("out/trajectory.csv")
    t.equal(path["step"], [20.0 * k for k in range(11)], "frames")
    t.equal(path["x2"], path["x2"][::-1], "the way back is the way there")
    t.equal(list(path), "step,time,x1,y1,vx1,vy1,x2,y2,vx2,vy2".split(","), "columns")
    t.equal(t.expect(2, t.run("run", "deck.toml", "--out", "out")).out, "", "stdout of a second run")


def cases():
    return [Case(test.__name__.replace("_", " "), test)
            for test in (files_written, h5md_is_the_default, default_directory, directory_of_the_deck, thermo_csv, si_columns,
                         rdf_csv, results_json, run_json, hash_tells_decks_apart, final_xyz, trajectory_xyz,
                         existing_run_is_refused, a_stopped_run_is_to_be_resumed, force_replaces_its_own_files_only, a_refused_deck_costs_nothing,
                         the_start_is_not_replaced, the_deck_is_not_replaced,
                         a_run_that_ends_meanwhile_is_not_replaced, output_is_a_file, json_on_stdout, table_on_stdout,
                         a_title_cannot_play_tricks, same_deck_same_bytes, output_does_not_disturb,
                         another_seed_is_another_run, commands_can_be_copied, few_bodies)]
