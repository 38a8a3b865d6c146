"""`ljmd compare` of fluids: what it prints and writes, when it fails, and what it refuses."""

import json
import os
import shutil

from harness import DECK, STARS, Case, Skip, clean_environment, compare_refused, snapshot

POINT = ("--parts", "point", "--quiet")
TRAJECTORY = ("--parts", "point,trajectory", "--steps", "20", "--quiet")


def needs(there, what):
    """Skip a case that needs another program; with LJMD_REQUIRE_PEERS=1 in the environment it fails."""
    if not there and os.environ.get("LJMD_REQUIRE_PEERS") == "1":
        raise OSError(f"there is no {what}, and LJMD_REQUIRE_PEERS=1")
    if not there:
        raise Skip(f"there is no {what}")


def needs_openmm(t):
    needs(json.loads(t.run_well("info", "--json").out)["openmm"], "OpenMM in this ljmd")


def module_for_openmm(t):
    """Without its module, or with a damaged one, the program works, and says why it cannot compare."""
    t.deck()
    shutil.copy(t.ljmd, t.dir / "ljmd")
    t.ljmd = str(t.dir / "ljmd")
    t.contains(t.run_well("info").out, "openmm        not built in")
    t.equal(json.loads(t.run_well("info", "--json").out)["openmm"], "", "version")
    absent = t.expect(2, t.run("compare", "deck.toml", "--with", "openmm", "--out", "out"))
    t.contains(absent.err, "this ljmd was built without OpenMM: there is no ")
    t.contains(absent.err, "/ljmd/ljmd_openmm.so; install it")
    module = t.dir / "ljmd_openmm.so"
    module.write_text("no library\n" * 1000)
    refused = f"the part of ljmd for OpenMM, {module}, cannot be loaded: "
    t.contains(t.run_well("info").out, f"openmm        {refused}")
    t.equal(json.loads(t.run_well("info", "--json").out)["openmm_platforms"], [], "platforms")
    for command in (("compare", "deck.toml", "--with", "openmm"), ("export", "deck.toml", "--to", "openmm")):
        damaged = t.expect(2, t.run(*command, "--out", "out"))
        t.contains(damaged.err, refused)
        t.contains(damaged.err, "ELF")
    t.equal(t.files(), ["deck.toml", "ljmd", "ljmd_openmm.so"], "files")


def needs_lammps(_t):
    needs(shutil.which("lmp"), "program 'lmp'")


def environment(**variables):
    return {**clean_environment(), **variables}


def everything(t):
    """All parts at once, on the screen, as JSON and as files. In 400 steps both follow one trajectory: means that are compared
    within three standard errors differ by less than a thousandth of one."""
    needs_openmm(t)
    t.deck(("steps = 40", "steps = 400"))
    result = t.run_well("compare", "deck.toml", "--with", "openmm", "--steps", "20", "--out", "some/where")
    for word in ("OpenMM", "Reference", "CPU, 1 thread", "108 atoms, after 20 steps of the deck", "verlet-list",
                 "potential energy", "step 10: leapfrog and VerletIntegrator", "kick-drift-kick",
                 "mean temperature", "g(r)", "million atom-steps/s", "checks passed"):
        t.contains(result.out, word)
    t.contains(result.err, "averaging over 400 steps")
    t.contains(result.out, "files: some/where\nto draw them: ljmd plot some/where\n")
    t.equal(t.files("some/where"), ["compare-openmm-rdf.csv", "compare-openmm-trajectory.csv", "compare-openmm.json"],
            "files")
    found = t.json("some/where/compare-openmm.json")
    t.equal(found["passed"], True, "verdict")
    for check in found["checks"]:
        t.equal(sorted(check), ["name", "passed", "tolerance", "value"], "keys of a check")
        t.check(0.0 <= check["value"] <= check["tolerance"], f"{check}")
    t.check(found["atom_steps_per_second"]["ljmd"] > 0.0, "speed of ljmd")
    t.equal(found["path"]["search"], "verlet-list", "path")
    rows = t.columns("some/where/compare-openmm-trajectory.csv")
    t.equal(rows["step"], [float(step) for step in range(21)], "steps of the trajectory")
    t.equal(rows["velocity-verlet - kick-drift-kick"],
            [row["distances"][2] for row in found["trajectory"]["rows"]], "distances in CSV and JSON")
    t.check(max(rows["leapfrog - VerletIntegrator"]) < 1e-12, "distances")
    t.check(len(t.columns("some/where/compare-openmm-rdf.csv")["g_peer"]) == 250, "bins of g(r)")


def json_alone(t):
    needs_openmm(t)
    t.deck()
    found = json.loads(t.run_well("compare", "deck.toml", "--with", "openmm", "--json", *POINT).out)
    t.equal(t.files(), ["deck.toml"], "files")
    t.equal([check["name"] for check in found["checks"]],
            ["potential energy", "largest force difference", "rms force difference", "pressure",
             "tail correction of the energy"], "checks")
    t.check("trajectory" not in found and "averages" not in found, "parts that nobody wanted")


def existing_files_are_refused(t):
    t.deck(text=STARS)
    command = ("compare", "deck.toml", "--with", "gsl", "--quiet", "--out", "out")
    t.run_well(*command)
    (t.dir / "out/compare-gsl.json").write_text("mine")
    before = snapshot(t.dir)
    t.golden(t.expect(2, t.run(*command)).err)
    t.equal(snapshot(t.dir), before, "files after the refusal")
    t.run_well(*command, "--force")
    t.check("checks" in t.read("out/compare-gsl.json") or "passed" in t.read("out/compare-gsl.json"), "--force replaces nothing")


def frames_are_judged(t):
    needs_openmm(t)
    t.deck()
    found = json.loads(t.run_well("compare", "deck.toml", "--with", "openmm", "--json", "--parts", "trajectory",
                                  "--steps", "9", "--frames", "3,7,20", "--quiet").out)
    t.equal(sorted({check["name"].split(":")[0] for check in found["checks"]}), ["step 3", "step 7"], "steps judged")


def every_path(t):
    """All searches, mixed precision, the CPU platform: what was tested is said."""
    needs_openmm(t)
    t.deck()
    for arguments, said in ((["--set", 'neighbors.method="all-pairs"', "--set", "neighbors.skin=0.0"], "all-pairs, scalar, double"),
                            (["--precision", "mixed"], "mixed precision"), (["--simd", "portable"], "portable"),
                            (["--threads", "2"], "2 threads"), (["--platform", "CPU"], "OpenMM")):
        t.contains(t.run_well("compare", "deck.toml", "--with", "openmm", *TRAJECTORY, *arguments).out, said)


def two_atoms_in_a_long_box(t):
    """Coordinates of 50 sigma over a short time step are coarse velocities: OpenMM takes its own from them."""
    needs_openmm(t)
    (t.dir / "two.xyz").write_text('2\nLattice="50 0 0 0 6 0 0 0 6"\nAr 49.9 1 1\nAr 1.2 1 1\n')
    t.deck(text="""
[system]
file = "two.xyz"
temperature = 1.0
seed = 5
[potential]
type = "lennard-jones"
cutoff = 2.0
truncation = "force-shifted"
[[stage]]
name = "p"
time_step = 0.002
steps = 200
sample = true
""")
    for step in ("0.002", "0.0002"):
        t.run_well("compare", "deck.toml", "--with", "openmm", "--parts", "point,trajectory", "--steps", "200",
                   "--set", f"stage.p.time_step={step}", "--quiet")


def missed_pairs_fail(t):
    """Lists that are built too seldom miss pairs: the trajectories differ, and the verdict says so."""
    needs_openmm(t)
    t.deck(("temperature = 1.0", "temperature = 3.0"))
    result = t.expect(5, t.run("compare", "deck.toml", "--with", "openmm", "--parts", "trajectory", "--steps", "100",
                               "--set", "neighbors.every=100", "--set", "neighbors.skin=0.01", "--quiet"))
    t.contains(result.out, "FAILED")
    t.contains(result.err, "differ: ")
    t.contains(result.err, "checks failed")


def lammps(t):
    needs_lammps(t)
    t.deck()
    result = t.run_well("compare", "deck.toml", "--with", "lammps", "--steps", "20", "--quiet", "--out", "out")
    for word in ("LAMMPS", "fix nve", "tail correction of the pressure", "checks passed"):
        t.contains(result.out, word)
    t.check("compare-lammps.json" in t.files("out"), "files")


def unknown_platform(t):
    needs_openmm(t)
    t.deck()
    result = t.expect(2, t.run("compare", "deck.toml", "--with", "openmm", "--platform", "Abacus"))
    t.equal(result.out, "", "stdout")
    for word in ("no platform 'Abacus'", "loaded: Reference", "CPU"):
        t.contains(result.err, word)


def plugin_folder_missing(t):
    needs_openmm(t)
    t.deck()
    result = t.expect(2, t.run("compare", "deck.toml", "--with", "openmm", "--platform", "CPU",
                               env=environment(OPENMM_PLUGIN_DIR="/not/there")))
    t.golden(result.err)
    # What needs no plug-in works.
    t.run_well("compare", "deck.toml", "--with", "openmm", *POINT, env=environment(OPENMM_PLUGIN_DIR="/not/there"))


def no_lammps(t):
    t.deck()
    t.golden(t.expect(2, t.run("compare", "deck.toml", "--with", "lammps", env=environment(LJMD_LAMMPS="/no/lmp"))).err)


def position_that_is_not_finite(t):
    t.deck(('lattice = { type = "fcc", cells = 3 }\ndensity = 0.8442', 'file = "start.xyz"'))
    (t.dir / "start.xyz").write_text('1\nLattice="6 0 0 0 6 0 0 0 6" Properties=species:S:1:pos:R:3\nX 1 nan 1\n')
    t.golden(t.expect(3, t.run("compare", "deck.toml", "--with", "openmm")).err)


def cases():
    return [Case(test.__name__.replace("_", " "), test)
            for test in (everything, json_alone, existing_files_are_refused, frames_are_judged, every_path,
                         two_atoms_in_a_long_box, missed_pairs_fail, module_for_openmm, lammps,
                         unknown_platform, plugin_folder_missing, no_lammps, position_that_is_not_finite)] + \
           [Case("few bodies with openmm", compare_refused(STARS, "--with", "openmm")),
            Case("few bodies with lammps", compare_refused(STARS, "--with", "lammps")),
            Case("unknown part", compare_refused(DECK, "--with", "openmm", "--parts", "point,speeds")),
            Case("frame before the first step", compare_refused(DECK, "--with", "openmm", "--frames", "0,1")),
            Case("negative steps", compare_refused(DECK, "--with", "openmm", "--steps", "-1")),
            Case("cutoff beyond half the box", compare_refused(DECK, "--with", "openmm", "--set", "potential.cutoff=2.6"))]
