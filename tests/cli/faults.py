"""Runs that cannot end well: they say where and why, and leave what they had."""

import os
import re
import resource

from harness import STARS, Case, Failure, Skip, clean_environment, snapshot

HOT = [("density = 0.8442", "density = 0.5"), ("temperature = 1.0", "temperature = 20.0"),
       ("time_step = 0.004\nsteps = 20", "time_step = 0.05\nsteps = 2000"),
       ('thermostat = { type = "rescale", every = 5 }\n', "")]


def explosion(t):
    t.deck(*HOT)
    result = t.expect(5, t.run("run", "deck.toml", "--force", "--out", "out"))
    t.equal(result.out, "", "stdout")
    error = result.err[result.err.index("error: "):]
    t.equal(error.count("error:"), 1, "times that it says 'error:'")
    t.check(re.match(r"error: step \d+ \(stage 'melt'\): (atom \d+ (moves [\d.e+]+ sigma in one step|has left its box by "
                     r"[\d.e+]+ sigma|was pushed out of the range of numbers)|the total energy has risen by [\d.e+]+ )", error),
            f"message: {error}")
    t.contains(error, "time step")
    t.contains(error, "the configuration is in out/failed.xyz\n")
    t.equal(t.read("out/failed.xyz").splitlines()[0], "108", "first line of failed.xyz")
    t.equal(t.json("out/run.json")["finished"], False, "finished")
    t.check(t.columns("out/thermo.csv")["step"], "thermo.csv has no rows")
    t.check(not (t.dir / "out/results.json").exists(), "a failed run has results")
    t.equal([name for name in t.files("out") if name.startswith(".")], [], "left-over files")
    t.contains(t.run_well("info", "out").out, "ljmd resume out")  # the last checkpoint is from before


def explosion_under_a_thermostat(t):
    """Rescaling at every step hides an explosion from the energy; the speed of single atoms shows it."""
    t.deck(("density = 0.8442", "density = 0.5"), ("time_step = 0.004\nsteps = 20", "time_step = 0.04\nsteps = 1000"),
           ('type = "rescale", every = 5', 'type = "rescale", every = 1'))
    result = t.expect(5, t.run("run", "deck.toml", "--force"))
    # Which of the two is seen first depends on roundings: nine steps lie between two looks at the speeds.
    t.check(re.search(r"error: step \d+ \(stage 'melt'\): atom \d+ (moves [\d.e+]+ sigma in one step|has left its box)",
                      result.err), f"message: {result.err}")


def explosion_of_fixed_point_sums(t):
    t.deck(("temperature = 1.0\n", "temperature = 300.0\n"), ("steps = 20\n", 'steps = 500\nintegrator = "bit-reversible"\n'),
           ("time_step = 0.004\nsteps = 500", "time_step = 0.0199\nsteps = 500"))
    result = t.expect(5, t.run("run", "deck.toml", "--force"))
    t.check(re.search(r"error: step \d+ \(stage 'melt'\): (forces reach 2\^18 epsilon/sigma.*Is the time step too large|atom \d+ )",
                      result.err), f"message: {result.err}")


def explosion_of_few_bodies(t):
    """Euler's rule with a step of many periods: energies leave the range of numbers, which no result may tell of."""
    t.deck(('type = "newtonian-gravity"\ngravitational_constant = 1.0\nsoftening = 0.0', 'type = "harmonic"\nstiffness = 1.0'),
           ("time_step = 0.01\nsteps = 100", 'time_step = 10.0\nsteps = 2000\nintegrator = "euler"'), text=STARS)
    result = t.expect(5, t.run("run", "deck.toml", "--out", "out", "--quiet"))
    t.check(re.match(r"error: step \d+ \(stage 'orbits'\): .*the run has blown up. Is the time step too large", result.err),
            f"message: {result.err}")
    for word in ("inf", "nan"):
        t.check(word not in t.read("out/thermo.csv"), f"thermo.csv tells of {word}")
    t.contains(t.run_well("info", "out").out, "ljmd resume out")


def late_lists_are_told_of(t):
    t.deck(("skin = 0.3", "skin = 0.05\nevery = 20"))
    result = t.run_well("run", "deck.toml", "--out", "out")
    t.check(re.search(r"warning: [1-9]\d* of \d+ neighbor lists were kept too long", result.err), f"message: {result.err}")


def slow_heating(t):
    """A time step a little too large heats without any explosion; the message tells by how much."""
    t.deck(("time_step = 0.004\nsteps = 20", "time_step = 0.032\nsteps = 3000"),
           ('thermostat = { type = "rescale", every = 5 }\n', ""))
    result = t.expect(5, t.run("run", "deck.toml", "--force"))
    t.check(re.search(r"error: step \d+ \(stage 'melt'\): the total energy has risen by [\d.]+ epsilon per atom", result.err),
            f"message: {result.err}")


def a_sound_run_is_left_alone(t):
    """The hottest run and the largest step that need no --force, and a melting crystal under a harsh cut, are sound."""
    for out, edits in (("hot", [("temperature = 1.0", "temperature = 50.0"), ("time_step = 0.004\nsteps = 40",
                                                                              "time_step = 0.001\nsteps = 400")]),
                       ("long", [("time_step = 0.004\nsteps = 40", "time_step = 0.0199\nsteps = 400")]),
                       ("harsh", [("cutoff = 2.5", "cutoff = 1.5"), ("steps = 40", "steps = 600")])):
        if out == "hot":
            edits = edits + [("time_step = 0.004\nsteps = 20", "time_step = 0.001\nsteps = 20")]
        t.deck(*edits)
        t.run_well("run", "deck.toml", "--quiet", "--out", out)


def failed_run_is_replaced(t):
    """failed.xyz is one of the files that --force removes."""
    t.deck(*HOT)
    t.expect(5, t.run("run", "deck.toml", "--force", "--out", "out"))
    t.expect(2, t.run("run", "deck.toml", "--out", "out", "--set", "stage.melt.time_step=0.001", "--set", "stage.melt.steps=5"))
    t.run_well("run", "deck.toml", "--out", "out", "--force", "--set", "stage.melt.time_step=0.001", "--set",
               "stage.melt.steps=5")
    t.check(not (t.dir / "out/failed.xyz").exists(), "failed.xyz of the earlier run is still there")


def overlap_in_a_start(t):
    """Two atoms that all but coincide: the force can be computed, the run cannot."""
    (t.dir / "pair.xyz").write_text('2\nLattice="6 0 0 0 6 0 0 0 6" Properties=species:S:1:pos:R:3 pbc="T T T"\n'
                                    "Ar 1 1 1\nAr 1.05 1 1\n")
    t.deck(('lattice = { type = "fcc", cells = 3 }\n', 'file = "pair.xyz"\n'), ("density = 0.8442\n", ""))
    result = t.expect(5, t.run("run", "deck.toml", "--quiet"))
    t.contains(result.err, "do atoms overlap at the start?")


def too_dense_to_relax(t):
    t.deck(('type = "fcc", cells = 3', 'type = "random", atoms = 30'), ("density = 0.8442", "density = 20.0"),
           ("cutoff = 2.5", "cutoff = 0.55"))
    result = t.expect(5, t.run("run", "deck.toml", "--force", "--quiet", "--out", "out"))
    t.contains(result.err, "did not relax the overlaps of the start")
    t.check(not (t.dir / "out").exists(), "there is a directory")


def output_below_a_file(t):
    t.deck()
    (t.dir / "file").write_text("mine")
    result = t.expect(4, t.run("run", "deck.toml", "--out", "file/out"))
    t.golden(result.err)
    t.equal(t.read("file"), "mine", "the file")


def read_only_directory(t):
    if os.geteuid() == 0:
        raise Skip("root writes everywhere")
    t.deck()
    (t.dir / "locked").mkdir()
    (t.dir / "locked").chmod(0o500)
    t.contains(t.expect(4, t.run("run", "deck.toml", "--out", "locked/out")).err, "Permission denied")
    t.contains(t.expect(4, t.run("run", "deck.toml", "--out", "locked")).err, "Permission denied")


def an_output_that_cannot_be_removed(t):
    t.deck()
    (t.dir / "out/run.json/inside").mkdir(parents=True)
    before = t.files()
    result = t.expect(2, t.run("run", "deck.toml", "--out", "out", "--force"))
    t.golden(result.err)
    t.equal(t.files(), before, "files")


def file_size_limit(t):
    """Like a full disk: every write of a run is allowed to fail, with exit code 4 and no crash."""
    t.deck(("thermo = { every = 5 }", 'thermo = { every = 1 }\ntrajectory = { format = "xyz", every = 1 }'))
    for limit in (0, 100, 2000, 20_000, 100_000):
        result = t.run("run", "deck.toml", "--quiet", "--force",
                       preexec_fn=lambda size=limit: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size)))
        t.expect(4, result)
        t.check(re.match(r"(warning: .*\n)*error: cannot write '", result.err), f"limit {limit}: {result.err}")


def little_room():
    """In the child: an address space of 1 GiB."""
    resource.setrlimit(resource.RLIMIT_AS, (1 << 30, 1 << 30))


def threads_that_cannot_be_had(t):
    """Found out before anything is written."""
    t.deck()
    before = t.files()
    result = t.run("run", "deck.toml", "--out", "out", env={**clean_environment(), "OMP_NUM_THREADS": "100000"})
    t.equal(t.expect(2, result).err,
            "error: OMP_NUM_THREADS is '100000': allowed is a number of threads from 1 to 4096\n", "the error")
    t.equal(t.files(), before, "files")
    try:
        t.run_well("--version", preexec_fn=little_room)
    except Failure as reason:  # the address sanitizer reserves terabytes
        raise Skip(f"the program cannot be run in a small address space: {reason}") from reason
    result = t.run("run", "deck.toml", "--out", "out", "--threads", "4096", preexec_fn=little_room)
    t.contains(t.expect(7, result).err, "error: 4096 threads are asked for, and the system allows no more than ")
    t.equal(t.files(), before, "files")


def another_run_survives(t):
    """Nothing that fails here touches a run beside it."""
    t.deck()
    t.run_well("run", "deck.toml", "--quiet", "--out", "beside")
    before = snapshot(t.dir / "beside")
    t.deck(*HOT)
    t.expect(5, t.run("run", "deck.toml", "--force", "--out", "beside/inner"))
    after = {name: data for name, data in snapshot(t.dir / "beside").items() if not name.startswith("inner")}
    t.equal(after, before, "the run beside")


def cases():
    return [Case(test.__name__.replace("_", " "), test)
            for test in (explosion, explosion_under_a_thermostat, explosion_of_fixed_point_sums,
                         explosion_of_few_bodies, late_lists_are_told_of, slow_heating, a_sound_run_is_left_alone,
                         failed_run_is_replaced,
                         overlap_in_a_start, too_dense_to_relax, output_below_a_file, read_only_directory,
                         an_output_that_cannot_be_removed, file_size_limit, threads_that_cannot_be_had,
                         another_run_survives)]
