"""ljmd evaluate: energy, virial, pressure and forces of configurations in every format, against published digits, a run of
0 steps and closed forms; and what it refuses."""

import csv
import json
import math
import re
import shutil

from pathlib import Path

from harness import ARGON, Case, STARS

NIST = Path(__file__).resolve().parent.parent / "data/nist"
CUT = ("--truncation", "cut", "--tail", "false")
PAIR = ("--cutoff", "2.5", *CUT)
ONLY_START = (("steps = 20", "steps = 0"), ("steps = 40", "steps = 0"))
CALCULATED = 'trajectory = { format = "xyz", every = 10, velocities = true, forces = true, energies = true }'


def evaluated(t, *arguments):
    return json.loads(t.run_well("evaluate", *arguments, "--json").out)


def printed_alike(t, found, printed, what):
    """A number rounded to the digits of a printed one is that one."""
    digits = len(re.sub(r"^0*|[^0-9]", "", printed.lstrip("-").replace(".", "")))
    t.equal(f"{float(printed):.{digits - 1}e}", f"{found:.{digits - 1}e}", what)


def nist(t):
    with open(NIST / "published.csv", encoding="utf-8") as lines:
        rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    t.equal(len(rows), 8, "published rows")
    for row in rows:
        path, atoms = NIST / f"lj_sample_config_periodic{row['config']}.txt", int(row["N"])
        plain = evaluated(t, path, "--cutoff", row["rc"], *CUT)
        printed_alike(t, atoms * plain["potential_energy"], row["U"], "U")
        printed_alike(t, plain["virial"], row["W"], "W")
        t.check(math.isclose(sum(plain["energies"]), atoms * plain["potential_energy"], rel_tol=1e-12), "sum of energies")
        trace = sum(plain["virial_tensor"][k][k] for k in range(3))
        t.check(math.isclose(plain["virial"], trace, rel_tol=1e-12), "trace")
        t.check(max(map(abs, plain["net_force"])) < 1e-9 * max(1.0, plain["largest_force"]), "net force")
        tail = evaluated(t, path, "--cutoff", row["rc"], "--truncation", "cut", "--tail", "true")
        printed_alike(t, atoms * (tail["potential_energy"] - plain["potential_energy"]), row["ULRC"], "tail")
        t.equal([tail["energies"], tail["forces"], tail["virial"]], [plain["energies"], plain["forces"], plain["virial"]],
                "the pairs are the same with a tail")
        if row["ULFS"]:
            smooth = evaluated(t, path, "--cutoff", row["rc"], "--truncation", "force-shifted")
            printed_alike(t, atoms * smooth["potential_energy"], row["ULFS"], "U of the force-shifted fluid")
            printed_alike(t, smooth["virial"], row["WLFS"], "W of the force-shifted fluid")


def a_run_of_0_steps(t):
    """The bits of the start of a run, by deck and by options, for any number of threads; with velocities its pressure."""
    t.deck(*ONLY_START)
    t.run_well("run", "deck.toml", "--out", "out", "--quiet")
    results = t.json("out/results.json")["observables"]
    found = evaluated(t, "out")
    for name in ("potential_energy", "pressure", "temperature"):
        t.equal(found[name], results[name]["mean"], name)
    t.equal(found["virial"], results["virial"]["mean"] if "virial" in results else t.json("out/results.json")["virial"],
            "virial")
    t.equal(found["pressure_parts"], "kinetic and virial", "pressure_parts")
    t.equal(found["remarks"], [], "remarks")
    for arguments in (("out/final.xyz", "--deck", "deck.toml"), ("out", "--threads", "3"),
                      ("out/final.xyz", "--cutoff", "2.5", "--truncation", "cut", "--tail", "true", "--threads", "2")):
        again = evaluated(t, *arguments)
        t.equal({**again, "configuration": ""}, {**found, "configuration": ""}, " ".join(arguments))
    t.equal(len(found["forces"]), 108, "forces")
    kinetic = found["pressure"] - found["virial_pressure"]
    t.check(math.isclose(kinetic, found["density"] * found["temperature"], rel_tol=1e-12), "kinetic part of the pressure")


def write_xyz(t, name, positions, edges=(8, 8, 8), extra=""):
    text = f"{len(positions)}\nLattice=\"{edges[0]} 0 0 0 {edges[1]} 0 0 0 {edges[2]}\" Properties=species:S:1:pos:R:3{extra}\n"
    (t.dir / name).write_text(text + "".join("X " + " ".join(map(str, r)) + "\n" for r in positions), encoding="utf-8")
    return name


def two_atoms_across_the_wall(t):
    r = 1.2
    found = evaluated(t, write_xyz(t, "two.xyz", [(0.3, 4, 4), (7.1, 4, 4)]), *PAIR)
    force = 24 * (2 * r**-13 - r**-7)
    energy = 4 * (r**-12 - r**-6)
    t.check(math.isclose(found["potential_energy"], energy / 2, rel_tol=1e-12), "energy")
    for k in (0, 1):
        t.check(math.isclose(found["energies"][k], energy / 2, rel_tol=1e-12), "energies of the atoms")
        t.check(math.isclose(found["forces"][k][0], force if k == 0 else -force, rel_tol=1e-11), f"force {k}")
    t.check(math.isclose(found["virial"], r * force, rel_tol=1e-11), "virial")
    t.check(math.isclose(found["pressure"], r * force / (3 * 8**3), rel_tol=1e-11), "pressure")
    t.equal(found["pressure_parts"], "virial", "pressure_parts")
    t.equal([found["temperature"], found["kinetic_energy"]], [None, None], "without velocities")
    t.contains(found["remarks"][0], "no velocities")
    one = evaluated(t, write_xyz(t, "one.xyz", [(1, 1, 1)]), *PAIR)
    t.equal([one["potential_energy"], one["forces"], one["energies"]], [0.0, [[0.0, 0.0, 0.0]], [0.0]], "a single atom")


def forces_are_slopes(t):
    """Finite differences of the energy, with a continuous potential."""
    how = ("--cutoff", "2.5", "--truncation", "force-shifted")
    t.deck()
    t.run_well("run", "deck.toml", "--out", "out", "--quiet")
    lines = t.read("out/final.xyz").splitlines()
    atoms, h = int(lines[0]), 1e-5
    forces = evaluated(t, "out/final.xyz", *how)["forces"]
    for atom, axis in ((0, 0), (57, 1), (107, 2)):
        def energy(by):
            fields = lines[2 + atom].split()
            fields[1 + axis] = repr(float(fields[1 + axis]) + by)
            moved = lines[:2 + atom] + [" ".join(fields)] + lines[3 + atom:]
            (t.dir / "moved.xyz").write_text("\n".join(moved) + "\n", encoding="utf-8")
            return atoms * evaluated(t, "moved.xyz", *how)["potential_energy"]
        slope = (energy(-h) - energy(h)) / (2 * h)
        t.check(math.isclose(slope, forces[atom][axis], rel_tol=1e-6, abs_tol=1e-6), f"{slope} {forces[atom][axis]}")


def every_format_and_all_frames(t):
    t.deck(("thermo = { every = 5 }", "thermo = { every = 5 }\ntrajectory = { format = \"xyz\", every = 10, velocities = true }"))
    t.run_well("run", "deck.toml", "--out", "xyz", "--quiet")
    t.run_well("run", "deck.toml", "--out", "h5md", "--quiet", "--set", "output.trajectory.format=h5md")
    rows = t.columns("xyz/thermo.csv")
    frames = evaluated(t, "xyz/trajectory.xyz", "--deck", "deck.toml", "--out", "all.xyz")["frames"]
    t.equal([frame["step"] for frame in frames], list(range(0, 61, 10)), "steps")
    t.equal([frame["frame"] for frame in frames], list(range(1, 8)), "numbers")
    for frame in frames:
        k = rows["step"].index(frame["step"])
        for name in ("potential_energy", "pressure", "temperature", "kinetic_energy"):
            t.check(math.isclose(frame[name], rows[name][k], rel_tol=1e-10), f"{name} of step {frame['step']}")
    h5md = evaluated(t, "h5md/trajectory.h5md", "--deck", "deck.toml")["frames"]
    t.equal([{**frame, "configuration": ""} for frame in h5md], [{**frame, "configuration": ""} for frame in frames], "H5MD")
    third = evaluated(t, "h5md/trajectory.h5md", "--deck", "deck.toml", "--frame", "3")
    t.equal(third, h5md[2], "one frame")
    written = t.read("all.xyz")
    t.equal(written.count("forces:R:3:energies:R:1:id:I:1"), 7, "frames with forces and energies")
    t.run_well("evaluate", "h5md/trajectory.h5md", "--deck", "deck.toml", "--out", "all.lammpsdump")
    dumped = evaluated(t, "all.lammpsdump", "--deck", "deck.toml", "--frame", "3")
    t.equal(dumped["step"], third["step"], "step of the dump")
    for mine, other in zip(dumped["forces"], third["forces"]):
        t.check(all(math.isclose(a, b, rel_tol=1e-10, abs_tol=1e-10) for a, b in zip(mine, other)), "forces from the dump")
    t.contains(t.read("all.lammpsdump"), "ITEM: ATOMS id type x y z ix iy iz vx vy vz fx fy fz c_pe\n")
    again = evaluated(t, "all.xyz", "--deck", "deck.toml", "--frame", "3")
    t.equal(again["forces"], third["forces"], "the file that was written")
    line = written.splitlines()[2 + 2 * 110].split()
    t.equal([float(x) for x in line[10:14]], [*third["forces"][0], third["energies"][0]], "forces and energy of an atom")
    t.run_well("export", "deck.toml", "--to", "lammps", "--out", "lammps", "--quiet")
    t.run_well("export", "deck.toml", "--to", "extxyz", "--out", "extxyz", "--quiet")
    lammps, extxyz = (evaluated(t, path, "--deck", "deck.toml") for path in ("lammps/start.data", "extxyz/start.xyz"))
    t.equal(lammps["potential_energy"], extxyz["potential_energy"], "LAMMPS data")
    dump = "".join(f"ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n0 8\n0 8\n0 8\n"
                   f"ITEM: ATOMS id type x y z\n7 1 7.1 4 {z}\n3 1 0.3 4 4\n" for step, z in ((0, 4), (5, 4.5)))
    (t.dir / "a.lammpsdump").write_text(dump, encoding="utf-8")
    two = evaluated(t, "a.lammpsdump", *PAIR)["frames"]
    t.equal(two[0]["ids"], [3, 7], "ids")
    t.check(two[0]["forces"][0][0] < 0 < two[0]["forces"][1][0], "forces are in the order of ids")


def forces_in_trajectories(t):
    """Those of the positions in the frame, with every kind of integrator; the run is the same without them, and resumed."""
    for format, integrator in (("xyz", "velocity-verlet"), ("xyz", "position-verlet"), ("h5md", "leapfrog")):
        t.deck(("thermo = { every = 5 }", CALCULATED.replace("xyz", format)),
               *((old, f'{old}\nintegrator = "{integrator}"') for old in ('name = "melt"', 'name = "production"')))
        name = f"{format}-{integrator}"
        t.run_well("run", "deck.toml", "--out", name, "--quiet")
        t.run_well("run", "deck.toml", "--out", f"{name}-plain", "--quiet", "--set", "output.trajectory.forces=false", "--set",
                   "output.trajectory.energies=false")
        for file in ("final.xyz", "thermo.csv"):
            t.equal(t.read(f"{name}/{file}"), t.read(f"{name}-plain/{file}"), f"{file} of {name}")
        if format != "xyz":
            continue  # the numbers of H5MD are read by tests/io/readers_test.py
        frames = evaluated(t, f"{name}/trajectory.xyz", "--deck", "deck.toml")["frames"]
        lines = t.read(f"{name}/trajectory.xyz").splitlines()
        t.contains(lines[1], ":forces:R:3:energies:R:1:id:I:1")
        scale = max(frame["largest_force"] for frame in frames)
        for k, frame in enumerate(frames):
            for atom in range(108):
                numbers = [float(x) for x in lines[110 * k + 2 + atom].split()[10:14]]
                expected = [*frame["forces"][atom], frame["energies"][atom]]
                t.check(all(math.isclose(a, b, abs_tol=1e-11 * scale) for a, b in zip(numbers, expected)),
                        f"{name}, frame {k + 1}, atom {atom + 1}: {numbers}, evaluated {expected}")
    stopped = t.run("run", "deck.toml", "--out", "stopped", "--quiet", "--walltime", "0.000001s")
    t.equal(stopped.code, 75, "the run is stopped")
    t.run_well("resume", "stopped", "--quiet")
    t.equal((t.dir / "stopped/trajectory.h5md").read_bytes(), (t.dir / "h5md-leapfrog/trajectory.h5md").read_bytes(), "resumed")


def screen(t):
    fcc = [(x + 0.01 * (y == 0), y, z) for x in range(0, 8, 2) for y in range(0, 8, 2) for z in range(0, 8, 2)]
    write_xyz(t, "a.xyz", fcc)
    text = t.run_well("evaluate", "a.xyz", "--cutoff", "2.5", "--truncation", "cut", "--tail", "true").out
    t.check(max(map(len, text.splitlines())) <= 80, "80 columns")
    for part in ("64 atoms", "truncation 'cut'", "potential energy", "of it tail", "no velocities", "largest forces"):
        t.contains(text, part)
    (t.dir / "two.xyz").write_text((t.dir / "a.xyz").read_text(encoding="utf-8") * 2, encoding="utf-8")
    table = t.run_well("evaluate", "two.xyz", *PAIR).out
    t.check(max(map(len, table.splitlines())) <= 80, "80 columns")
    t.contains(table, "max force")
    t.contains(table, "the virial part alone")


def si_units(t):
    t.deck(*ONLY_START, ("[system]", ARGON + "\n[system]"),
           ("thermo = { every = 5 }", 'trajectory = { format = "xyz", every = 1, units = "si" }'))
    t.run_well("run", "deck.toml", "--out", "out", "--quiet")
    result = t.expect(3, t.run("evaluate", "out/trajectory.xyz", *PAIR))
    t.contains(result.err, "[argon]")
    found = evaluated(t, "out/trajectory.xyz", "--deck", "deck.toml")
    t.check(math.isclose(found["potential_energy"], evaluated(t, "out")["potential_energy"], rel_tol=1e-12), "energy")


def refused(code, *arguments, expected=()):
    def test(t):
        t.deck()
        t.deck(text=STARS, name="stars.toml")
        write_xyz(t, "two.xyz", [(0.3, 4, 4), (7.1, 4, 4)])
        write_xyz(t, "same.xyz", [(0.3, 4, 4), (0.3, 4, 4)])
        write_xyz(t, "nan.xyz", [(0.3, 4, "nan"), (7.1, 4, 4)])
        shutil.copy(NIST / "lj_sample_config_periodic4.txt", t.dir / "nist.txt")
        before = t.files()
        result = t.expect(code, t.run("evaluate", *arguments))
        t.equal(t.files(), before, "files")
        t.golden(result.err)
    return test


def copies_tell_no_more_than_their_source(t):
    """Step, time, ids and the wrapping of positions are written where the file has them, in both formats."""
    atoms = [(1.5, 1.5, 1.5), (4.5, 4.5, 4.5), (1.5, 4.5, -0.5)]
    for told, says in (("", ""), ("Time=0.5", "Time=0.5 "), ("step=7", "step=7 "),
                       ("step=7 positions=unwrapped", "step=7 positions=unwrapped ")):
        write_xyz(t, "a.xyz", atoms, extra=f" {told}")
        t.run_well("evaluate", "a.xyz", *PAIR, "--out", "copy.xyz", "--force")
        line = t.read("copy.xyz").splitlines()[1]
        for word in ("Time=", "step=", "positions=unwrapped"):
            t.equal(word in line, word in says, f"{word} in the copy of a file with {told!r}")
        t.check(":id:I:1" not in line, "no ids")
        dump = t.run("evaluate", "a.xyz", *PAIR, "--out", "copy.lammpsdump", "--force")
        t.equal(dump.code, 0 if "step" in told else 2, f"a dump of a file with {told!r}")
        if "step" in told:
            t.equal("ix iy iz" in t.read("copy.lammpsdump"), "unwrapped" in told, "image flags")
        else:
            t.contains(dump.err, "every frame of a dump of LAMMPS has a step")
    (t.dir / "a.dump").write_text("ITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n0 8\n0 8\n0 8\n"
                                  "ITEM: ATOMS id x y z\n7 7.1 4 4\n3 0.3 4 4\n", encoding="utf-8")
    t.run_well("evaluate", "a.dump", *PAIR, "--out", "ids.xyz")
    t.equal([row.split()[-1] for row in t.read("ids.xyz").splitlines()[2:]], ["3", "7"], "ids")


def forces_beyond_the_range_of_squares(t):
    write_xyz(t, "close.xyz", [(1, 1, 1), (1, 1, 1.0000000000001), (4, 4, 4)])
    found = evaluated(t, "close.xyz", *PAIR)
    t.equal(found["largest_force"], max(abs(force[2]) for force in found["forces"]), "the largest force")
    t.check(1e170 < found["largest_force"] < 1e171, "48 / r^13")
    t.check("inf" not in t.run_well("evaluate", "close.xyz", *PAIR).out, "on screen")


def a_file_is_not_replaced_unasked(t):
    write_xyz(t, "two.xyz", [(0.3, 4, 4), (7.1, 4, 4)])
    before = t.read("two.xyz")
    result = t.expect(2, t.run("evaluate", "two.xyz", *PAIR, "--out", "two.xyz"))
    t.contains(result.err, "--force")
    t.equal(t.read("two.xyz"), before, "the file")
    t.run_well("evaluate", "two.xyz", *PAIR, "--out", "new.xyz")
    t.run_well("evaluate", "two.xyz", *PAIR, "--out", "new.xyz", "--force")
    t.deck(*ONLY_START)
    t.run_well("run", "deck.toml", "--out", "out", "--quiet")
    t.contains(t.expect(2, t.run("evaluate", "out", "--out", "out/more.xyz")).err, "directory of a run")


def cases():
    tests = (nist, a_run_of_0_steps, two_atoms_across_the_wall, forces_are_slopes, every_format_and_all_frames,
             forces_in_trajectories, screen,
             si_units, a_file_is_not_replaced_unasked, copies_tell_no_more_than_their_source,
             forces_beyond_the_range_of_squares)
    return [Case(test.__name__.replace("_", " "), test) for test in tests] + [
        Case("no file", refused(3, "nowhere.xyz", *PAIR)),
        Case("a deck is no configuration", refused(3, "deck.toml", *PAIR)),
        Case("no potential", refused(2, "two.xyz")),
        Case("no tail", refused(2, "two.xyz", "--cutoff", "2.5", "--truncation", "cut")),
        Case("no start of the switch", refused(2, "two.xyz", "--cutoff", "2.5", "--truncation", "switched", "--tail", "true")),
        Case("a tail of a shifted potential", refused(2, "two.xyz", "--cutoff", "2.5", "--truncation", "shifted", "--tail", "true")),
        Case("a switch of a cut potential", refused(2, "two.xyz", *PAIR, "--switch-start", "2")),
        Case("a cutoff with a unit", refused(2, "two.xyz", "--cutoff", "8.5 angstrom", *CUT)),
        Case("a cutoff that is none", refused(2, "two.xyz", "--cutoff", "-1", *CUT)),
        Case("a cutoff beyond half the box", refused(2, "two.xyz", "--cutoff", "4.5", *CUT)),
        Case("parameters that are missing", refused(2, "two.xyz", *PAIR, "--potential", "morse")),
        Case("a parameter that is no number", refused(2, "two.xyz", *PAIR, "--potential", "morse", "--parameter", "steepness=soft")),
        Case("a parameter of another potential", refused(2, "two.xyz", *PAIR, "--parameter", "steepness=6")),
        Case("a deck and a potential", refused(2, "two.xyz", *PAIR, "--deck", "deck.toml")),
        Case("settings without a deck", refused(2, "two.xyz", *PAIR, "--set", "potential.cutoff=2.0")),
        Case("a deck of few bodies", refused(2, "two.xyz", "--deck", "stars.toml")),
        Case("atoms at the same place", refused(3, "same.xyz", *PAIR)),
        Case("a position that is no number", refused(3, "nan.xyz", *PAIR)),
        Case("a frame that is not there", refused(3, "two.xyz", *PAIR, "--frame", "2")),
        Case("a group of an XYZ file", refused(3, "two.xyz", *PAIR, "--group", "all")),
        Case("a group of a NIST file", refused(2, "nist.txt", *PAIR, "--group", "all")),
        Case("an output of another format", refused(2, "two.xyz", *PAIR, "--out", "two.pdb"))]
