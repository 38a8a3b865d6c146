"""ljmd analyze of trajectories: what a run has measured itself comes out of its frames again, in whatever format they are;
and what cannot be analyzed is refused.

Files by h5py, MDAnalysis and ASE are read by tests/io/foreign_trajectories.py.
"""

import gzip
import json
import math
import random
import re

from pathlib import Path

from harness import ARGON, Case, DECK, STARS

DATA = Path(__file__).resolve().parent.parent / "data"

ANALYSIS = """
[analysis]
rdf = { every = 10, bins = 50 }
structure_factor = { every = 20, k_max = 6.0 }
msd = { every = 10, max_time = 0.2 }
vacf = { every = 5, max_time = 0.1 }
viscosity = { every = 5, max_time = 0.1 }
chemical_potential = { every = 20, insertions = 200 }
response_functions = { every = 20 }
configurational_temperature = { every = 20 }
cutoff_correction = { every = 20 }
"""
TRAJECTORY = ("thermo = { every = 5 }",
              'thermo = { every = 5 }\ntrajectory = { format = "xyz", every = 5, velocities = true }')
LONG = ("steps = 40", "steps = 400")
ALL = ("rdf", "structure_factor", "msd", "vacf", "viscosity", "chemical_potential", "response_functions",
       "configurational_temperature", "cutoff_correction")
TABLES = ("rdf", "sk_from_rdf", "sk", "msd", "vacf", "vibrational_spectrum", "stress_autocorrelation")
OBSERVABLES = ("coordination_number", "diffusion", "diffusion_green_kubo", "viscosity", "excess_chemical_potential",
               "temperature", "diffusion_infinite_system", "configurational_temperature", "isothermal_compressibility",
               "thermal_expansion", "thermal_pressure_coefficient", "heat_capacity_cp", "adiabatic_compressibility",
               "speed_of_sound", "joule_thomson_coefficient", "cutoff_energy", "cutoff_pressure", "cutoff_energy_response",
               "cutoff_pressure_response")
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
            ours, theirs = found[name][key], expected[name][key]
            t.equal(ours is None, theirs is None, f"{name} has a {key}")
            t.check(ours is None or math.isclose(ours, theirs, rel_tol=1e-9), f"{name}: {found[name]}")


def frames_of_a_run(*settings):
    def test(t):
        run(t, *settings)
        before = {path: path.read_bytes() for path in (t.dir / "out").iterdir()}
        as_the_run(t, "out/analysis", t.run_well("analyze", "out", *ALL, "--json"))
        after = {path: path.read_bytes() for path in (t.dir / "out").iterdir() if path.is_file()}
        t.equal(after, before, "the run's own files")
    return test


def fluxes_of_a_run(*settings):
    """Thermal conductivity and bulk viscosity, which need a continuous potential; with the run's own and another number of
    threads."""
    def test(t):
        names = ("thermal_conductivity", "bulk_viscosity")
        continuous = DECK.replace('"cut"', '"shifted"').replace("tail = true\n", "") + "".join(
            ["\n[analysis]\n", *(f"{name} = {{ every = 5, max_time = 0.1 }}\n" for name in names)])
        run(t, *settings, text=continuous)
        tables = ("heat_flux_autocorrelation", "pressure_autocorrelation")
        for threads in ("1", "3"):
            result = t.run_well("analyze", "out", *names, "--json", "--force", env={"OMP_NUM_THREADS": threads})
            as_the_run(t, "out/analysis", result, tables, (*names, "temperature"))
        t.deck(text=DECK)
        t.golden("".join(t.expect(2, t.run("analyze", "out/trajectory.xyz", name, "--deck", "deck.toml")).err for name in names))
    return test


def read_xyz(text):
    """Frames of (step, edges, atoms), an atom being id, position and velocity."""
    lines = text.splitlines()
    while lines:
        count = int(lines[0])
        lattice = [float(x) for x in re.search(r'Lattice="([^"]*)"', lines[1])[1].split()]
        rows = [line.split() for line in lines[2:2 + count]]
        atoms = [(int(row[10]), [float(x) for x in row[1:4]], row[4:7]) for row in rows]
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
    t.equal(json.loads(result.out)["positions"]["told_by"], "file", "positions")


def a_wrapped_lammps_dump(t):
    """Atoms are followed by their nearest images, and that is said."""
    run(t)
    name = write_dump(t, images=False)
    result = t.run_well("analyze", name, *ALL, "--deck", "deck.toml", *SAMPLED, "--json")
    as_the_run(t, "dump-analysis", result)
    t.equal(json.loads(result.out)["positions"]["taken_as"], "wrapped", "positions")
    t.contains(t.run_well("analyze", name, "msd", "--time-step", "0.004", "--out", "again").out, "nearest images")
    t.check("positions:" not in t.run_well("analyze", name, "rdf", "vacf", "--time-step", "0.004", "--out", "more").out,
            "positions are described where it does not matter")


def frames_in_a_foreign_place(t):
    """Of an H5MD file and an XYZ file anywhere, with the deck of the run."""
    run(t, "output.trajectory.format=h5md")
    (t.dir / "a.bin").write_bytes((t.dir / "out/trajectory.h5md").read_bytes())
    as_the_run(t, "a-analysis", t.run_well("analyze", "a.bin", *ALL, "--deck", "deck.toml", *SAMPLED, "--json"))


def a_compressed_dump(t):
    run(t)
    name = write_dump(t, images=True)
    text = (t.dir / name).read_bytes()
    (t.dir / name).write_bytes(gzip.compress(text[:5000]) + gzip.compress(text[5000:]))
    as_the_run(t, "dump-analysis", t.run_well("analyze", name, *ALL, "--deck", "deck.toml", *SAMPLED, "--json"))


def a_box_whose_tilt_factors_are_zero(t):
    run(t)
    name = write_dump(t, images=True)
    text = t.read(name).replace("BOX BOUNDS pp", "BOX BOUNDS xy xz yz pp")
    (t.dir / name).write_text(re.sub(r"^(-1\.5 [\d.]+)$", r"\1 1e-15", text, flags=re.M))
    as_the_run(t, "dump-analysis", t.run_well("analyze", name, *ALL, "--deck", "deck.toml", *SAMPLED, "--json"))


def the_dump_of_a_group(t):
    """Each third atom alone: its ids have gaps. Its distances are those with ids that have none; its motion is not told."""
    run(t)
    for name, first, apart in (("group.xyz", 1, 3), ("dense.xyz", 1, 1)):
        frames = []
        for step, edges, atoms in read_xyz(t.read("out/trajectory.xyz")):
            rows = [f"{first + apart * k} {r[0]!r} {r[1]!r} {r[2]!r}\n" for k, (_, r, _) in enumerate(atoms[::3])]
            frames.append(f'{len(rows)}\nLattice="{edges[0]} 0 0 0 {edges[1]} 0 0 0 {edges[2]}" '
                          f"Properties=id:I:1:pos:R:3 step={step} units=reduced\n" + "".join(reversed(rows)))
        (t.dir / name).write_text("".join(frames))
        found = json.loads(t.run_well("analyze", name, "rdf", "--time-step", "0.004", "--json").out)
        t.equal(found["atoms"], 36, "atoms")
    t.equal(t.read("group-analysis/rdf.csv"), t.read("dense-analysis/rdf.csv"), "rdf")
    t.contains(t.expect(2, t.run("analyze", "group.xyz", "msd", "--time-step", "0.004")).err,
               "msd needs all atoms: motion is measured about the centre of mass of all of them")
    t.contains(t.run_well("analyze", "group.xyz", "--time-step", "0.004", "--out", "usual").err,
               "warning: msd is left out: motion is measured about the centre of mass of all of them")
    t.check("msd.csv" not in t.files("usual"), "msd of part of the atoms")


def a_dump_that_was_appended_to(t):
    """Frames that come again are counted once, whether the last one comes again or the run went back to a restart file."""
    run(t)
    name = write_dump(t, images=True)
    frames = ["ITEM: TIMESTEP" + frame for frame in t.read(name).split("ITEM: TIMESTEP")[1:]]
    for again, words in ((1, "1 frame, frame 41, repeats a step"), (5, "5 frames, the first of them frame 41, repeat steps")):
        (t.dir / name).write_text("".join(frames[:40] + frames[40 - again:]))
        result = t.run_well("analyze", name, *ALL, "--deck", "deck.toml", *SAMPLED, "--json", "--force")
        as_the_run(t, "dump-analysis", result)
        t.contains(result.err, words)
        t.check("gap" not in result.err, result.err)
    moved = [re.sub(r"^(1 \S+ \S+ \S+) (-?\d+)", lambda m: f"{m[1]} {int(m[2]) + 1}", frame, flags=re.M) for frame in frames]
    (t.dir / name).write_text("".join(frames[:40] + moved[35:]))
    result = t.run_well("analyze", name, "msd", "--deck", "deck.toml", "--json", "--force")
    t.contains(result.err, "nothing is compared in time across the gap")
    msd = t.columns("dump-analysis/msd.csv")["msd"]
    t.check(max(msd) < 1, f"the jump of an edge between two runs is in the displacements: {max(msd)}")


def positions_of_cp2k(t):
    """Its comment lines are no key=value: box and units are told beside the file."""
    t.deck(text=DECK + ARGON)
    lines = [f"Ar {3.405 * x + 0.1} {3.405 * y} {3.405 * z}\n" for x in range(3) for y in range(3) for z in range(3)]
    (t.dir / "pos.xyz").write_text("".join(f"27\n i = {k}, time = {k}.500, E = -12.5\n{''.join(lines)}" for k in range(4)))
    comment = 'Lattice="20.43 0 0 0 20.43 0 0 0 20.43" units=si'
    result = t.run_well("analyze", "pos.xyz", "rdf", "msd", "--deck", "deck.toml", "--time-step", "0.5", "--json",
                        "--xyz-comment", comment)
    found = json.loads(result.out)
    t.check(all(abs(edge - 6) < 1e-12 for edge in found["box_edges"]), f"edges {found['box_edges']}")
    t.equal((found["frames"], found["spacing"]), (4, 0.5), "frames")
    t.golden(t.expect(3, t.run("analyze", "pos.xyz")).err +
             t.expect(3, t.run("analyze", "pos.xyz", "--xyz-comment", comment)).err)


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
    t.equal(json.loads(result.out)["observables"]["coordination_number"]["mean"], None, "of 5 configurations")


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
    return "".join(frame(f"Time={time}", **options) for time in times)


WITH_VELOCITIES = {"columns": ":velo:R:3", "values": " 0 0 1"}


def refused(code, text, *arguments, encoding="utf-8"):
    """A trajectory that is not analyzed: a golden message, and nothing is written."""
    def test(t):
        t.deck()
        (t.dir / "a.xyz").write_bytes(text.encode(encoding))
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
    told = t.run_well("analyze", "a.xyz", "--out", "structure").err
    t.contains(told, "warning: msd is left out: the frames have no times: --time-step gives the time between steps")
    t.check("msd.csv" not in t.files("structure"), "msd without times")
    t.run_well("analyze", "a.xyz", "msd", "--time-step", "0.5")
    t.equal(t.columns("a-analysis/msd.csv")["time"][:2], [0.0, 0.5], "times")


def walls(wrap_every, step=0.5, edge=5.0, keys=""):
    """Eight atoms on a lattice. In each frame the first one moves by `step`, the last one by -step.

    Positions are wrapped every so many frames (0: never), as LAMMPS does when it builds lists: between two wrappings
    atoms may lie outside the box."""
    text = ""
    for number in range(40):
        text += f'8\nLattice="{edge} 0 0 0 {edge} 0 0 0 {edge}" Time={number} {keys}\n'
        for atom in range(8):
            x, y, z = (edge * (0.25 + 0.5 * (atom >> axis & 1)) for axis in (2, 1, 0))
            velocity = step * {0: 1, 7: -1}.get(atom, 0)
            edges = math.floor((x + velocity * (number - number % wrap_every)) / edge) if wrap_every else 0
            text += f"X {x + velocity * number - edges * edge:.6f} {y:.6f} {z:.6f}\n"
    return text


def positions_through_the_walls(t):
    """msd is the same however a file has its positions; units are no proof that they are unwrapped."""
    (t.dir / "deck.toml").write_text(DECK + ARGON)
    files = {"late": walls(3), "wrapped": walls(1), "unwrapped": walls(0),
             "si": walls(1, step=0.5 * 3.405, edge=5 * 3.405, keys="units=si")}
    for name, text in files.items():
        (t.dir / f"{name}.xyz").write_text(text)
        argon = ("--deck", "deck.toml") if name == "si" else ()
        result = t.run_well("analyze", f"{name}.xyz", "msd", "--json", *argon)
        columns = t.columns(f"{name}-analysis/msd.csv")
        t.check(math.isclose(columns["msd"][4], 2 / 8 * (4 * 0.5)**2, rel_tol=1e-4), f"{name}: {columns['msd'][:5]}")
        found = json.loads(result.out)["positions"]
        t.equal((found["taken_as"], found["told_by"]), ("unwrapped" if name == "unwrapped" else "wrapped", "displacements"),
                name)
    t.contains(t.run_well("analyze", "late.xyz", "msd", "--force").out,
               "positions: wrapped, atoms followed by their nearest images, at most 0.1 edges away (told by displacements)")


def positions_that_nothing_tells(t):
    """Atoms that move by more than a quarter of an edge a frame: which displacement is meant has to be said."""
    (t.dir / "a.xyz").write_text(walls(1, step=2.0))
    t.golden(t.expect(2, t.run("analyze", "a.xyz", "msd")).err + t.run_well("analyze", "a.xyz").err)
    t.check("msd.csv" not in t.files("a-analysis"), "msd of what nothing tells")
    for how, msd in (("wrapped", 2 / 8 * 4.0), ("unwrapped", None)):
        result = t.run_well("analyze", "a.xyz", "msd", "--positions", how, "--out", how, "--json")
        found = json.loads(result.out)["positions"]
        t.equal((found["taken_as"], found["told_by"]), (how, "--positions"), how)
        t.check(msd is None or math.isclose(t.columns(f"{how}/msd.csv")["msd"][1], msd, rel_tol=1e-3), f"msd, {how}")
    t.expect(2, t.run("analyze", "a.xyz", "msd", "--positions", "folded"))


def with_velocities(text):
    """Frames of walls() with the velocity of each atom, the same for all."""
    text = re.sub(r'(Lattice="[^"]*")', r"\1 Properties=species:S:1:pos:R:3:velo:R:3", text)
    return re.sub("^(X .*)$", r"\1 0.1 0.2 0.3", text, flags=re.MULTILINE)


def time_correlations_of_foreign_frames(t):
    """What msd refuses, and what it follows through the walls, the other functions of two times refuse and follow, in the same words."""
    damaged = {"without times": re.sub(r" Time=\d+", "", walls(3)), "uneven": walls(3).replace("Time=7 ", "Time=7.5 "),
               "far": walls(1, step=2.0), "another box": walls(3).replace("5.0 0 0 0 5.0 0", "5.5 0 0 0 5.0 0", 1)}
    for name, made, more in (("van_hove", str, {}), ("van_hove_distinct", str, {"between": 8, "radius": 2.4}), ("scattering", with_velocities, {})):
        for what, text in damaged.items():
            (t.dir / "a.xyz").write_text(made(text))
            wanted = t.expect(2, t.run("analyze", "a.xyz", "msd")).err
            t.equal(t.expect(2, t.run("analyze", "a.xyz", name)).err, wanted.replace("msd", name), f"{name}, {what}")
        settings = {"every": 1, "max_time": 4, **more}
        tables = {}
        for file, wrap_every in (("late", 3), ("unwrapped", 0)):
            (t.dir / f"{file}.xyz").write_text(made(walls(wrap_every)))
            t.run_well("analyze", f"{file}.xyz", name, "--out", f"{name}-{file}",
                       *(word for key, value in settings.items() for word in ("--set", f"analysis.{name}.{key}={value}")))
            tables[file] = [t.columns(f"{name}-{file}/{each}") for each in t.files(f"{name}-{file}") if each.endswith(".csv")]
        t.check(tables["late"], f"{name} has tables")
        for late, unwrapped in zip(tables["late"], tables["unwrapped"], strict=True):
            for column, values in late.items():
                t.check(all(math.isclose(a, b, rel_tol=1e-4, abs_tol=1e-5) or (math.isnan(a) and math.isnan(b))
                            for a, b in zip(values, unwrapped[column], strict=True)), f"{name} through the walls: {column}")


def shivering_lattice(atoms, edge):
    """Lines of a dump, frame after frame: a cubic lattice that shivers, with the same velocities."""
    generator = random.Random(4)
    cells = round(atoms**(1 / 3))
    velocities = [[generator.gauss(0, 1) for _ in range(3)] for _ in range(atoms)]
    while True:
        lines = []
        for atom, velocity in enumerate(velocities):
            place = [(atom // cells**axis % cells) * edge / cells + generator.uniform(-0.1, 0.1) for axis in (0, 1, 2)]
            lines.append(" ".join([str(atom + 1), "1", *map(repr, place + velocity)]) + "\n")
        yield "".join(lines)


def a_deck_that_the_frames_contradict(t):
    """c_v by the formula of constant volume, of a dump whose box grows: no value, and why."""
    t.deck()
    places = shivering_lattice(64, 6)
    text = ""
    for number in range(6):
        edge = 6 + 0.6 * number
        text += f"ITEM: TIMESTEP\n{number}\nITEM: NUMBER OF ATOMS\n64\nITEM: BOX BOUNDS pp pp pp\n" + f"0 {edge}\n" * 3
        text += "ITEM: ATOMS id type x y z vx vy vz\n" + next(places)
    (t.dir / "grows.dump").write_text(text)
    result = t.run_well("analyze", "grows.dump", "thermo", "--deck", "deck.toml", "--json")
    found = json.loads(result.out)["observables"]["heat_capacity_cv"]
    t.equal(found["mean"], None, "heat capacity")
    t.contains(found["remark"], "the box changes, in frame 2")
    t.contains(t.run_well("analyze", "grows.dump", "thermo", "--deck", "deck.toml").out, "the box changes, in frame 2")
    refused = t.expect(2, t.run("analyze", "grows.dump", "chemical_potential", "--deck", "deck.toml"))
    t.contains(refused.err, "needs a box that stays the same")


def units_of_the_first_frame(t):
    """units=si in the first frame alone: the others are not reduced; what contradicts it is refused."""
    (t.dir / "deck.toml").write_text(DECK + ARGON)
    frames = [f'2\nLattice="34.05 0 0 0 34.05 0 0 0 34.05" Time={k} {{}}\nAr 0 0 0\nAr 3.7 0 0\n' for k in (0, 1)]
    (t.dir / "a.xyz").write_text(frames[0].format("units=si") + frames[1].format(""))
    found = json.loads(t.run_well("analyze", "a.xyz", "rdf", "--deck", "deck.toml", "--json").out)
    t.check(math.isclose(found["box_edges"][0], 10), f"edges: {found['box_edges']}")
    t.check("box" not in " ".join(found["warnings"]), "warnings")
    t.run_well("analyze", "a.xyz", "structure_factor", "--deck", "deck.toml")  # of a box that stays the same
    (t.dir / "b.xyz").write_text(frames[0].format("") + frames[1].format("units=si"))
    t.golden(t.expect(3, t.run("analyze", "b.xyz", "rdf", "--deck", "deck.toml")).err)


def two_kinds_of_atoms(t):
    """In whatever format and column they are told apart."""
    header = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n" + "0 6\n" * 3
    files = {"element.dump": header + "ITEM: ATOMS id element x y z\n1 Kr 1 1 1\n2 Ar 2 1 1\n",
             "mass.dump": header + "ITEM: ATOMS id type mass x y z\n1 1 1 1 1 1\n2 1 2 2 1 1\n",
             "z.xyz": frame().replace("species:S:1:pos:R:3", "pos:R:3:Z:I:1").replace("X 1 1 1", "1 1 1 18").replace(
                 "X 2.2 1 1", "2.2 1 1 36"),
             "frames.xyz": frame() + frame().replace("X", "Kr")}
    said = ""
    for name, text in files.items():
        (t.dir / name).write_text(text)
        said += t.expect(3, t.run("analyze", name, "rdf")).err
    for name in ("species_in_time.h5md", "species_enum.h5md", "velocity_at_other_steps.h5md"):
        (t.dir / name).write_bytes((DATA / "h5md" / name).read_bytes())
    t.golden(said + t.expect(3, t.run("analyze", "species_in_time.h5md")).err)
    t.run_well("analyze", "species_enum.h5md")


def velocities_at_other_steps(t):
    """They matter to what needs them alone."""
    t.deck()
    (t.dir / "a.h5md").write_bytes((DATA / "h5md/velocity_at_other_steps.h5md").read_bytes())
    found = json.loads(t.run_well("analyze", "a.h5md", "rdf", "--json").out)
    t.equal(found["frames_used"], 2, "frames")
    t.check("temperature" not in found["observables"], "a temperature of velocities at other steps")
    (t.dir / "b.xyz").write_text(frame("Time=0") + frame("Time=1", **WITH_VELOCITIES) + frame("Time=2"))
    t.equal(json.loads(t.run_well("analyze", "b.xyz", "rdf", "--json").out)["frames_used"], 3, "frames")
    t.golden("".join(t.expect(2, t.run("analyze", name, analysis, "--deck", "deck.toml")).err
                     for name in ("a.h5md", "b.xyz") for analysis in ("vacf", "thermo")))


def cases():
    named = (a_compressed_dump, a_box_whose_tilt_factors_are_zero, the_dump_of_a_group, a_dump_that_was_appended_to,
             positions_of_cp2k, a_lammps_dump_with_image_flags, thermodynamics_of_frames, a_wrapped_lammps_dump, frames_in_a_foreign_place, without_names,
             settings_count_frames, thermo_and_more, cut_off, in_si_units, tables_that_are_there, without_a_trajectory,
             a_few_bodies, a_box_that_changes, without_times, time_correlations_of_foreign_frames, positions_through_the_walls, positions_that_nothing_tells,
             a_deck_that_the_frames_contradict, units_of_the_first_frame, two_kinds_of_atoms, velocities_at_other_steps)
    uneven = timed(0, 1, 3, 4, **WITH_VELOCITIES)
    return [Case(test.__name__.replace("_", " "), test) for test in named] + [
        Case("the frames of a run in XYZ", frames_of_a_run()),
        Case("the frames of a run in H5MD", frames_of_a_run("output.trajectory.format=h5md")),
        Case("the frames of two stages", frames_of_a_run("stage.melt.sample=true", "stage.melt.steps=100")),
        Case("heat flux and pressure of the frames of a run", fluxes_of_a_run()),
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
        Case("a trajectory in UTF-16", refused(3, "\ufeff" + timed(0, 1), encoding="utf-16-le")),
        Case("a trajectory with lines that end in CR", refused(3, timed(0, 1).replace("\n", "\r"))),
        Case("a trajectory of XTC", refused(3, "\0\0\x07\xcb\0\0", encoding="latin-1")),
        Case("a comment for a dump", refused(3, "ITEM: TIMESTEP\n", "--xyz-comment", "units=si")),
        Case("a damaged trajectory", refused(3, timed(0, 1).replace("X 2.2", "X 2.2.2"))),
        Case("atoms that overlap", refused(3, timed(0, 1, 2, **WITH_VELOCITIES).replace("X 2.2", "X 1"), "viscosity",
                                           "--deck", "deck.toml")),
        Case("a deck for a run", refused_run(2, "out", "rdf", "--deck", "deck.toml")),
        Case("the tables of the run itself", refused_run(2, "out", "rdf", "--out", "out", "--force")),
        Case("a file as directory", refused_run(2, "out", "rdf", "--out", "deck.toml")),
        Case("a run without velocities", refused_run(2, "out", "vacf", settings=("output.trajectory.velocities=false",)))]
