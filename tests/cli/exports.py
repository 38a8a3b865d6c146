"""ljmd export: the start of a deck, or the end of a run, for other programs."""

import json
import re

from harness import DECK, STARS, Case, snapshot

FROM_FILE = (('lattice = { type = "fcc", cells = 3 }\ndensity = 0.8442\ntemperature = 1.0\n', 'file = "{}"\n'),)


def next_deck(t, file):
    """A deck that starts from an exported configuration and runs no step."""
    start = [(old, new.format(file)) for old, new in FROM_FILE]
    t.deck(*start, ('steps = 20\nthermostat = { type = "rescale", every = 5 }', "steps = 0"),
           ("steps = 40", "steps = 0"), name="next.toml")
    t.run_well("run", "next.toml", "--quiet", "--out", "next", "--force")
    return t.json("next/results.json")["observables"]


def lammps(t):
    t.deck()
    result = t.run_well("export", "deck.toml", "--to", "lammps")
    t.equal(result.err, "warning: left out: stage 'melt'; the motion exported is that of 'production'\n", "stderr")
    t.golden(result.out)
    t.equal(t.files(), ["deck-lammps", "deck-lammps/in.lammps", "deck-lammps/start.data", "deck.toml"], "files")
    text = t.read("deck-lammps/in.lammps")
    for line in ("units lj", "read_data start.data", "pair_style lj/cut 2.5", "pair_modify tail yes", "timestep 0.004",
                 "variable steps index 40", "neigh_modify every 1 delay 0 check yes"):
        t.contains(text, line + "\n")


def json_says_the_same(t):
    t.deck()
    found = json.loads(t.run_well("export", "deck.toml", "--to", "extxyz", "--json", "--out", "some/where").out)
    t.equal(found, {"target": "extxyz", "files": ["some/where/start.xyz"], "atoms": 108, "step": 0, "stage": "production",
                    "time_step": 0.004, "warnings": []}, "JSON")
    t.equal(t.files(), ["deck.toml", "some", "some/where", "some/where/start.xyz"], "files")


def every_configuration_can_be_started_from(t):
    """What is exported has the energy of what was exported."""
    t.deck()
    t.run_well("run", "deck.toml", "--quiet", "--out", "out")
    ends = []
    for target, file in (("extxyz", "start.xyz"), ("lammps", "start.data"), ("h5md", "start.h5md")):
        t.run_well("export", "out", "--to", target)
        ends.append(next_deck(t, f"out-{target}/{file}"))
    wanted = float(t.read("out/thermo.csv").splitlines()[-1].split(",")[3])
    for found in ends:
        t.check(abs(found["potential_energy"]["mean"] - wanted) < 1e-12, f"energy {found['potential_energy']}, {wanted}")


def forces_are_those_of_the_potential(t):
    """With --forces extended XYZ and H5MD hold them; other targets, which compute them, refuse the option."""
    t.deck()
    t.run_well("run", "deck.toml", "--quiet", "--out", "out")
    for target, file in (("extxyz", "start.xyz"), ("h5md", "start.h5md")):
        t.run_well("export", "out", "--to", target, "--forces", "--out", target)
        found = json.loads(t.run_well("evaluate", f"{target}/{file}", "--deck", "deck.toml", "--json").out)
        if target == "extxyz":
            lines = t.read(f"{target}/{file}").splitlines()
            t.contains(lines[1], ":forces:R:3:")
            rows = [[float(word) for word in line.split()[10:13]] for line in lines[2:]]
            worst = max(abs(a - b) for row, force in zip(rows, found["forces"]) for a, b in zip(row, force))
            t.check(worst < 1e-10, f"forces differ by {worst}")
    t.run_well("export", "out", "--to", "extxyz", "--out", "plain")
    t.check(":forces:" not in t.read("plain/start.xyz"), "forces that nobody asked for")
    for target in ("lammps", "openmm"):
        t.contains(t.expect(2, t.run("export", "out", "--to", target, "--forces", "--out", "refused")).err,
                   f"--forces: {target} computes them itself")
    t.check(not any(name.startswith("refused") for name in t.files()), "something was written")


def a_run_needs_its_directory_alone(t):
    (t.dir / "deep").mkdir()
    t.deck(name="deep/deck.toml")
    t.run_well("run", "deep/deck.toml", "--quiet", "--out", "runs/one", "--set", "potential.cutoff=2.4")
    (t.dir / "deep/deck.toml").unlink()
    before = snapshot(t.dir / "runs")
    t.golden(t.run_well("export", "runs/one/", "--to", "lammps").out)
    t.contains(t.read("one-lammps/in.lammps"), "pair_style lj/cut 2.4\n")
    t.run_well("export", "runs/one", "--to", "h5md", "--out", "here", "--set", "potential.cutoff=2.3")
    t.equal(t.files("here"), ["start.h5md"], "files")
    t.run_well("export", ".", "--to", "lammps", "--out", "there", cwd=t.dir / "runs/one")
    t.equal(t.read("runs/one/there/start.data"), t.read("one-lammps/start.data"), "data of the same run")
    for name in ("start.data", "in.lammps"):
        (t.dir / "runs/one/there" / name).unlink()
    (t.dir / "runs/one/there").rmdir()
    t.equal(snapshot(t.dir / "runs"), before, "the run")


def existing_files_are_refused(t):
    t.deck()
    t.run_well("export", "deck.toml", "--to", "lammps", "--out", "out")
    (t.dir / "out/in.lammps").write_text("mine")
    (t.dir / "out/start.data").unlink()
    before = snapshot(t.dir)
    t.golden(t.expect(2, t.run("export", "deck.toml", "--to", "lammps", "--out", "out")).err)
    t.equal(snapshot(t.dir), before, "files after the refusal")
    (t.dir / "out/notes").write_text("mine")
    t.run_well("export", "deck.toml", "--to", "lammps", "--out", "out", "--force")
    t.check(t.read("out/in.lammps") != "mine", "--force replaces nothing")
    t.equal(t.read("out/notes"), "mine", "another file")


def the_start_is_not_replaced(t):
    t.deck()
    t.run_well("export", "deck.toml", "--to", "extxyz", "--out", ".")
    t.deck((FROM_FILE[0][0], FROM_FILE[0][1].format("start.xyz")), ('{ type = "rescale", every = 5 }\n',
                                                                   '{ type = "rescale", every = 5 }\ntemperature = 1.0\n'),
           name="next.toml")
    before = snapshot(t.dir)
    result = t.expect(2, t.run("export", "next.toml", "--to", "extxyz", "--out", ".", "--force"))
    t.golden(result.err)
    t.equal(snapshot(t.dir), before, "files after the refusal")


def output_is_a_file(t):
    t.deck()
    (t.dir / "taken").write_text("mine")
    t.golden(t.expect(2, t.run("export", "deck.toml", "--to", "extxyz", "--out", "taken")).err)
    t.equal(t.read("taken"), "mine", "the file")


def a_tail_is_warned_of(t):
    t.deck(('truncation = "cut"', 'truncation = "switched"\nswitch_start = 2.0'))
    t.golden(t.run_well("export", "deck.toml", "--to", "lammps").err)
    t.equal(t.run_well("export", "deck.toml", "--to", "lammps", "--force", "--quiet").err, "", "stderr with --quiet")


def names(t):
    """A run whose name is as long as a name may be, and one whose name TOML must quote."""
    t.deck()
    for name in (255 * "x", 'a "b" \\c'):
        t.run_well("run", "deck.toml", "--quiet", "--out", name)
        told = t.run_well("export", name, "--to", "extxyz").out
        line = re.search(r"in a deck: \[system\] (file = .*); in Python", told).group(1)
        t.deck((FROM_FILE[0][0], line + "\n"), ('thermostat = { type = "rescale", every = 5 }', ""), name="next.toml")
        t.run_well("run", "next.toml", "--quiet", "--out", "next", "--force")
        t.check((t.dir / f"{name[:248]}-extxyz/start.xyz").exists(), "the directory has another name")


def few_body_run(t):
    t.deck(text=STARS)
    t.run_well("run", "deck.toml", "--quiet", "--out", "stars")
    t.golden(t.expect(2, t.run("export", "stars", "--to", "lammps")).err)
    t.check(not (t.dir / "stars-lammps").exists(), "something was written")


def run_that_has_not_ended(t):
    t.deck()
    t.run_well("run", "deck.toml", "--quiet", "--out", "out")
    (t.dir / "out/final.xyz").unlink()
    t.golden(t.expect(3, t.run("export", "out", "--to", "lammps")).err)


def start_of_a_run_is_past(t):
    t.deck()
    t.run_well("run", "deck.toml", "--quiet", "--out", "out")
    t.golden(t.expect(2, t.run("export", "out", "--to", "lammps", "--set", "system.density=0.5")).err)


def larger_cutoff_than_the_box_of_a_run(t):
    t.deck()
    t.run_well("run", "deck.toml", "--quiet", "--out", "out")
    t.golden(t.expect(2, t.run("export", "out", "--to", "lammps", "--set", "potential.cutoff=2.6")).err)


def refused(code, text, *arguments):
    def test(t):
        t.deck(text=text)
        (t.dir / "empty").mkdir()
        result = t.expect(code, t.run("export", *arguments))
        t.equal(result.out, "", "stdout")
        t.equal(t.files(), ["deck.toml", "empty"], "files")
        t.golden(result.err)
    return test


def cases():
    morse = DECK.replace('type = "lennard-jones"', 'type = "morse"\nwell_depth = 1.0\nsteepness = 6.0\nminimum = 1.12')
    switched = morse.replace('truncation = "cut"', 'truncation = "switched"\nswitch_start = 2.0')
    return [Case(test.__name__.replace("_", " "), test)
            for test in (lammps, json_says_the_same, every_configuration_can_be_started_from, forces_are_those_of_the_potential,
                         a_run_needs_its_directory_alone, existing_files_are_refused, the_start_is_not_replaced,
                         output_is_a_file, names,
                         a_tail_is_warned_of, few_body_run, run_that_has_not_ended, start_of_a_run_is_past,
                         larger_cutoff_than_the_box_of_a_run)] + \
           [Case("unknown target", refused(2, DECK, "deck.toml", "--to", "gromacs")),
            Case("no target", refused(2, DECK, "deck.toml")),
            Case("few-body deck", refused(2, STARS, "deck.toml", "--to", "lammps")),
            Case("directory that is no run", refused(3, DECK, "empty", "--to", "extxyz")),
            Case("deck that is not there", refused(2, DECK, "deck.tml", "--to", "extxyz")),
            Case("deck without a name", refused(2, DECK, "", "--to", "extxyz")),
            Case("deck with a mistake", refused(2, DECK, "deck.toml", "--to", "extxyz", "--set", "system.density=-1")),
            Case("potential that LAMMPS does not have", refused(2, switched, "deck.toml", "--to", "lammps"))]
