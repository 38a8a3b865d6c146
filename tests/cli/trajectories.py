"""ljmd analyze of trajectories: what a run has measured itself comes out of its frames again, in whatever format they are;
and what cannot be analyzed is refused.

Files by h5py, MDAnalysis and ASE are read by tests/io/foreign_trajectories.py.
"""

import json
import math
import random
import re

from harness import ARGON, Case, DECK, STARS

ANALYSIS = """
[analysis]
rdf = { every = 10, bins = 50 }
structure_factor = { every = 20, k_max = 6.0 }
msd = { every = 10, max_time = 0.2 }
vacf = { every = 5, max_time = 0.1 }
viscosity = { every = 5, max_time = 0.1 }
chemical_potential = { every = 20, insertions = 200 }
"""
TRAJECTORY = ("thermo = { every = 5 }",
              'thermo = { every = 5 }\ntrajectory = { format = "xyz", every = 5, velocities = true }')
LONG = ("steps = 40", "steps = 400")
ALL = ("rdf", "structure_factor", "msd", "vacf", "viscosity", "chemical_potential")
TABLES = ("rdf", "sk_from_rdf", "sk", "msd", "vacf", "vibrational_spectrum", "stress_autocorrelation")
OBSERVABLES = ("coordination_number", "diffusion", "diffusion_green_kubo", "viscosity", "excess_chemical_potential",
               "temperature", "diffusion_infinite_system")
SAMPLED = ("--from", "0.081")  # the first stage lasts 0.08 tau


def run(t, *settings, text=DECK + ANALYSIS):
    t.deck(LONG, TRAJECTORY, text=text)
    arguments = [part for setting in settings for part in ("--set", setting)]
    t.run_well("run", "deck.toml", "--out", "out", "--quiet", *arguments)


def same_numbers(t, found, expected, what, tolerance=1e-9):
    """Two CSV files with the same columns and numbers, to a relative difference; near zero to that of the column."""
    ours, theirs = t.columns(found), t.columns(expected)
    t.equal(list(ours), list(theirs), f"{what}: columns")
    for name, column in theirs.items():
        t.equal(len(ours[name]), len(column), f"{what}: rows")
        largest = max((abs(x) for x in column if x is not None), default=0.0)
        for x, y in zip(ours[name], column):
            t.equal(x is None, y is None, f"{what}: {name} is known")
            t.check(x is None or abs(x - y) <= tolerance * abs(y) + 1e-3 * tolerance * largest,
                    f"{what}: {name} is {x!r}, the run has {y!r}")


def as_the_run(t, directory, result, tables=TABLES, observables=OBSERVABLES):
    """The tables in a directory, and the JSON that was printed, are those of the run."""
    for table in tables:
        same_numbers(t, f"{directory}/{table}.csv", f"out/{table}.csv", table)
    expected = t.json("out/results.json")["observables"]
    found = json.loads(result.out)["observables"]
    t.equal(sorted(found), sorted(observables), "observables")
    for name in observables:
        for key in ("mean", "standard_error"):
            t.check(math.isclose(found[name][key], expected[name][key], rel_tol=1e-9), f"{name}: {found[name]}")


def frames_of_a_run(*settings):
    def test(t):
        run(t, *settings)
        before = {path: path.read_bytes() for path in (t.dir / "out").iterdir()}
        as_the_run(t, "out/analysis", t.run_well("analyze", "out", *ALL, "--json"))
        after = {path: path.read_bytes() for path in (t.dir / "out").iterdir() if path.is_file()}
        t.equal(after, before, "the run's own files")
    return test


def read_xyz(text):
    """Frames of (step, edges, atoms), an atom being id, position and velocity."""
    lines = text.splitlines()
    while lines:
        count = int(lines[0])
        lattice = [float(x) for x in re.search(r'Lattice="([^"]*)"', lines[1])[1].split()]
        rows = [line.split() for line in lines[2:2 + count]]
        atoms = [(int(row[7]), [float(x) for x in row[1:4]], row[4:7]) for row in rows]
        yield int(re.search(r"step=(\d+)", lines[1])[1]), lattice[::4], atoms
        lines = lines[2 + count:]


def write_dump(t, images, name="dump.lammpstrj"):
    """The frames of the run as LAMMPS writes them: wrapped, with image flags or not, atoms in any order, another corner of
    the box."""
    shuffled = random.Random(5)
    corner = -1.5
    text = []
    for step, edges, atoms in read_xyz(t.read("out/trajectory.xyz")):
        text.append(f"ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n{len(atoms)}\nITEM: BOX BOUNDS pp pp pp\n")
        text += [f"{corner!r} {corner + edge!r}\n" for edge in edges]
        text.append(f"ITEM: ATOMS type vx vy vz {'ix iy iz ' if images else ''}id x y z \n")
        shuffled.shuffle(atoms)
        for number, position, velocity in atoms:
            crossed = [math.floor(x / edge) for x, edge in zip(position, edges)]
            inside = [repr(x - n * edge + corner) for x, n, edge in zip(position, crossed, edges)]
            flags = [str(n) for n in crossed] if images else []
            text.append(" ".join(["1", *velocity, *flags, str(number), *inside]) + "\n")
    (t.dir / name).write_text("".join(text))
    return name


def a_lammps_dump_with_image_flags(t):
    run(t)
    name = write_dump(t, images=True)
    result = t.run_well("analyze", name, *ALL, "--deck", "deck.toml", *SAMPLED, "--json")
    as_the_run(t, "dump-analysis", result)
    t.check("images" not in result.err, result.err)


def a_wrapped_lammps_dump(t):
    """Atoms are followed by their nearest images, and that is said once."""
    run(t)
    name = write_dump(t, images=False)
    result = t.run_well("analyze", name, *ALL, "--deck", "deck.toml", *SAMPLED, "--json")
    as_the_run(t, "dump-analysis", result)
    t.equal(result.err.count("nearest images"), 1, "warnings")
    t.equal(t.run_well("analyze", name, "rdf", "vacf", "--time-step", "0.004", "--out", "again").err.count("images"), 0,
            "warnings where positions are not followed")


def frames_in_a_foreign_place(t):
    """Of an H5MD file and an XYZ file anywhere, with the deck of the run."""
    run(t, "output.trajectory.format=h5md")
    (t.dir / "a.bin").write_bytes((t.dir / "out/trajectory.h5md").read_bytes())
    as_the_run(t, "a-analysis", t.run_well("analyze", "a.bin", *ALL, "--deck", "deck.toml", *SAMPLED, "--json"))


def thermodynamics_of_frames(t):
    """Energies, pressures and the heat capacity, as the run has them of its rows, which are at the same steps."""
    run(t)
    result = t.run_well("analyze", "out/trajectory.xyz", "thermo", "--deck", "deck.toml", *SAMPLED, "--json")
    expected = t.json("out/results.json")["observables"]
    names = [name for name in expected if name not in OBSERVABLES or name == "temperature"]
    t.check({"total_energy", "pressure", "compressibility_factor", "heat_capacity_cv"} <= set(names), f"names: {names}")
    as_the_run(t, "", result, tables=[], observables=names)
    t.contains(t.run_well("analyze", "out/trajectory.xyz", "thermo", "rdf", "--deck", "deck.toml").out, "total_energy")


def without_names(t):
    run(t)
    result = t.run_well("analyze", "out/trajectory.xyz")
    t.equal(t.files("out/trajectory-analysis"), ["msd.csv", "rdf.csv", "sk.csv", "sk_from_rdf.csv"], "files")
    t.contains(result.out, "85 frames of 108 atoms")
    t.contains(result.out, "85 measured, 0.02 tau apart")
    t.contains(result.out, "diffusion")
    t.contains(result.out, "files: out/trajectory-analysis")


def settings_count_frames(t):
    run(t)
    result = t.run_well("analyze", "out", "rdf", "--set", "analysis.rdf.bins=10", "--set", "analysis.rdf.every=2", "--json")
    t.equal(len(t.columns("out/analysis/rdf.csv")["r"]), 10, "bins")
    t.equal(json.loads(result.out)["frames_used"], 80, "frames")
    result = t.run_well("analyze", "out/trajectory.xyz", "rdf", "--set", "analysis.rdf.every=17", "--out", "few", "--json")
    t.equal(json.loads(result.out)["observables"]["coordination_number"]["samples"], 5, "every 17th of 85 frames")


def thermo_and_more(t):
    run(t)
    text = t.run_well("analyze", "out", "thermo", "rdf", "--from", "0.5").out
    t.contains(text, "60 rows of thermo.csv, steps 125 to 420")
    t.contains(text, "60 measured")
    found = json.loads(t.run_well("analyze", "out", "rdf", "thermo", "--from", "0.5", "--force", "--json").out)
    t.equal(found["thermo"]["first_step"], 125, "first step")
    t.equal(found["frames_used"], 60, "frames")


def cut_off(t):
    run(t)
    whole = t.read("out/trajectory.xyz")
    (t.dir / "cut.xyz").write_text(whole[:-40])
    result = t.run_well("analyze", "cut.xyz", "rdf", "--json")
    t.equal(json.loads(result.out)["frames"], 84, "frames")
    t.contains(result.err, "cut.xyz:")
    t.contains(result.err, "frame 85: ")
    t.contains(result.err, "the 84 frames before it are used")


def in_si_units(t):
    for form in ("h5md", "xyz"):
        run(t, f"output.trajectory.format={form}", "output.trajectory.units=si", text=DECK + ARGON + ANALYSIS)
        as_the_run(t, "out/analysis", t.run_well("analyze", "out", *ALL, "--json"))
        t.contains(t.read("out/analysis/rdf.csv"), "r_nm")
        refused = t.expect(3, t.run("analyze", f"out/trajectory.{form}", "rdf"))
        t.contains(refused.err, "a deck with [argon] is needed (analyze: --deck)")
        t.run_well("analyze", f"out/trajectory.{form}", "rdf", "--deck", "deck.toml", "--set", "analysis.rdf.bins=3")
        for path in sorted((t.dir / "out").rglob("*"), reverse=True):
            path.unlink() if path.is_file() else path.rmdir()


FRAME = """2
Lattice="6 0 0 0 6 0 0 0 6" Properties=species:S:1:pos:R:3{columns} {keys}
X 1 1 1{values}
X 2.2 1 1{values}
"""


def frame(keys="", columns="", values=""):
    return FRAME.format(keys=keys, columns=columns, values=values)


def timed(*times, **options):
    return "".join(frame(f"Time={time} units=reduced", **options) for time in times)


WITH_VELOCITIES = {"columns": ":velo:R:3", "values": " 0 0 1"}


def refused(code, text, *arguments):
    """A trajectory that is not analyzed: a golden message, and nothing is written."""
    def test(t):
        t.deck()
        (t.dir / "a.xyz").write_text(text)
        result = t.expect(code, t.run("analyze", "a.xyz", *arguments))
        t.equal(result.out, "", "stdout")
        t.equal(t.files(), ["a.xyz", "deck.toml"], "files")
        t.golden(result.err)
    return test


def refused_run(code, *arguments, settings=()):
    def test(t):
        run(t, *settings)
        before = t.files()
        result = t.expect(code, t.run("analyze", *arguments))
        t.equal(result.out, "", "stdout")
        t.equal(t.files(), before, "files")
        t.golden(result.err)
    return test


def tables_that_are_there(t):
    run(t)
    t.run_well("analyze", "out", "rdf")
    t.run_well("analyze", "out", "msd")
    before = t.read("out/analysis/rdf.csv")
    t.golden(t.expect(2, t.run("analyze", "out", "msd", "rdf", "--set", "analysis.rdf.bins=5")).err)
    t.equal(t.read("out/analysis/rdf.csv"), before, "rdf.csv")
    t.run_well("analyze", "out", "rdf", "--force", "--set", "analysis.rdf.bins=5")
    t.check(t.read("out/analysis/rdf.csv") != before, "rdf.csv stays in spite of --force")


def without_a_trajectory(t):
    t.deck()
    t.run_well("run", "deck.toml", "--out", "out", "--quiet")
    t.golden(t.expect(3, t.run("analyze", "out", "rdf")).err)


def a_few_bodies(t):
    t.deck(("thermo = { every = 10 }", 'trajectory = { format = "xyz", every = 10 }'), text=STARS)
    t.run_well("run", "deck.toml", "--out", "out", "--quiet")
    t.golden(t.expect(2, t.run("analyze", "out", "rdf")).err + t.expect(3, t.run("analyze", "out/trajectory.xyz")).err +
             t.expect(2, t.run("analyze", "out/trajectory.xyz", "--deck", "deck.toml")).err)


def a_box_that_changes(t):
    text = frame() + frame().replace("6 0 0 0 6", "6.5 0 0 0 6")
    (t.dir / "a.xyz").write_text(text)
    t.run_well("analyze", "a.xyz")
    t.equal(t.files("a-analysis"), ["rdf.csv", "sk_from_rdf.csv"], "files")
    t.golden(t.expect(2, t.run("analyze", "a.xyz", "structure_factor")).err)


def without_times(t):
    """Frames that tell neither step nor time: the time between them comes from the command line."""
    (t.dir / "a.xyz").write_text("".join(frame() for _ in range(20)))
    t.run_well("analyze", "a.xyz", "--out", "structure")
    t.check("msd.csv" not in t.files("structure"), "msd without times")
    t.run_well("analyze", "a.xyz", "msd", "--time-step", "0.5")
    t.equal(t.columns("a-analysis/msd.csv")["time"][:2], [0.0, 0.5], "times")


def cases():
    named = (a_lammps_dump_with_image_flags, thermodynamics_of_frames, a_wrapped_lammps_dump, frames_in_a_foreign_place, without_names,
             settings_count_frames, thermo_and_more, cut_off, in_si_units, tables_that_are_there, without_a_trajectory,
             a_few_bodies, a_box_that_changes, without_times)
    uneven = timed(0, 1, 3, 4, **WITH_VELOCITIES)
    return [Case(test.__name__.replace("_", " "), test) for test in named] + [
        Case("the frames of a run in XYZ", frames_of_a_run()),
        Case("the frames of a run in H5MD", frames_of_a_run("output.trajectory.format=h5md")),
        Case("the frames of two stages", frames_of_a_run("stage.melt.sample=true", "stage.melt.steps=100")),
        Case("an analysis that there is not", refused(2, timed(0, 1), "rdff")),
        Case("thermo without velocities", refused(2, timed(0, 1), "thermo")),
        Case("thermo without a deck", refused(2, timed(0, 1, **WITH_VELOCITIES), "thermo")),
        Case("no velocities", refused(2, timed(0, 1, 2), "vacf")),
        Case("frames that are not equally spaced", refused(2, uneven, "msd")),
        Case("frames without times", refused(2, frame() + frame(), "rdf", "msd")),
        Case("no interaction", refused(2, timed(0, 1, 2, **WITH_VELOCITIES), "viscosity")),
        Case("a cutoff beyond the box", refused(2, timed(0, 1, **WITH_VELOCITIES).replace("6 0 0 0 6", "4 0 0 0 6"),
                                                "chemical_potential", "--deck", "deck.toml")),
        Case("settings of what is not measured", refused(2, timed(0, 1), "rdf", "--set", "analysis.msd.every=2")),
        Case("a setting that there is not", refused(2, timed(0, 1), "rdf", "--set", "analysis.rdf.bin=2")),
        Case("a setting that does not fit", refused(2, timed(0, 1, 2), "msd", "--set", "analysis.msd.max_time=7")),
        Case("nothing as late as that", refused(3, timed(0, 1), "rdf", "--from", "5")),
        Case("from a time without times", refused(2, frame(), "--from", "5")),
        Case("a time that is none", refused(2, timed(0, 1), "--from", "nan")),
        Case("a time step that is none", refused(2, frame(), "--time-step", "0")),
        Case("a deck that is not there", refused(2, timed(0, 1), "--deck", "nowhere.toml")),
        Case("no trajectory at all", refused(3, "hello\n")),
        Case("a damaged trajectory", refused(3, timed(0, 1).replace("X 2.2", "X 2.2.2"))),
        Case("atoms that overlap", refused(3, timed(0, 1, 2, **WITH_VELOCITIES).replace("X 2.2", "X 1"), "viscosity",
                                           "--deck", "deck.toml")),
        Case("a deck for a run", refused_run(2, "out", "rdf", "--deck", "deck.toml")),
        Case("the tables of the run itself", refused_run(2, "out", "rdf", "--out", "out", "--force")),
        Case("a file as directory", refused_run(2, "out", "rdf", "--out", "deck.toml")),
        Case("a run without velocities", refused_run(2, "out", "vacf", settings=("output.trajectory.velocities=false",)))]
