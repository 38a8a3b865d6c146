"""What is no file stands where ljmd reads or writes one: a directory, a pipe, a link that leads elsewhere.

A pipe that is opened is waited for, so each of these commands would hang.
"""

import os
import shutil

from harness import Case, Skip, clean_environment, snapshot

SWEEP = ("sweep", "deck.toml", "--grid", "system.density=0.8|0.85", "--jobs", "1", "--quiet", "--out", "out")
WORDS = {"directory": "is a directory, not a regular file", "pipe": "is a pipe, not a regular file"}


def put(kind, path):
    """Something of this kind in place of a file."""
    path.unlink(missing_ok=True)
    if kind == "directory":
        path.mkdir()
    else:
        os.mkfifo(path)


def take_away(path):
    if path.is_dir():
        path.rmdir()
    else:
        path.unlink()


def record_of_a_run(kind):
    def test(t):
        t.deck()
        t.run_well("run", "deck.toml", "--quiet", "--out", "out")
        put(kind, t.dir / "out/run.json")
        for command in (("resume", "out"), ("resume", "out", "--threads", "2"), ("info", "out"), ("analyze", "out"),
                        ("export", "out", "--to", "lammps")):
            result = t.expect(3, t.run(*command))
            t.equal(result.err, f"error: out/run.json: {WORDS[kind]}\n", "stderr of " + " ".join(command))
            t.equal(result.out, "", "stdout of " + " ".join(command))
    return test


def rows_of_a_run(kind):
    def test(t):
        t.deck()
        t.run_well("run", "deck.toml", "--quiet", "--out", "out")
        put(kind, t.dir / "out/thermo.csv")
        t.equal(t.expect(3, t.run("analyze", "out")).err, f"error: out/thermo.csv: {WORDS[kind]}\n", "stderr")
    return test


def records_of_a_sweep(kind):
    def test(t):
        t.deck()
        t.run_well(*SWEEP)
        point = t.dir / "out/points/density=0.8"
        record = t.dir / "out/sweep.json"
        text = record.read_bytes()
        put(kind, record)
        t.equal(t.expect(3, t.run(*SWEEP)).err, f"error: out/sweep.json: {WORDS[kind]}\n", "stderr")
        take_away(record)
        record.write_bytes(text)
        # What is wrong with one point is that point's failure: the others are run.
        for name in ("results.json", "run.json"):
            put(kind, point / name)
            t.contains(t.expect(5, t.run(*SWEEP)).err, f"density=0.8: out/points/density=0.8/{name}: {WORDS[kind]}\n")
    return test


def logs_are_not_written_through(t):
    t.deck()
    (t.dir / "precious").write_text("mine")
    points = t.dir / "out/points"
    t.run_well(*SWEEP)
    shutil.rmtree(points / "density=0.8")
    log = points / "density=0.8.log"
    log.unlink()
    log.symlink_to(t.dir / "precious")
    before = snapshot(t.dir)
    result = t.expect(2, t.run(*SWEEP))
    t.equal(result.err, "error: out/points/density=0.8.log is in the way: a log is written there, and it is no file. "
                        "Nothing was run.\n", "stderr")
    t.equal(snapshot(t.dir), before, "files")
    log.unlink()
    os.mkfifo(log)
    t.contains(t.expect(2, t.run(*SWEEP)).err, "density=0.8.log is in the way")

    rows = t.dir / "table/rows"
    rows.mkdir(parents=True)
    (rows / "rho0.5000-T1.360.log").symlink_to(t.dir / "precious")
    result = t.expect(2, t.run("reproduce", "verlet1967", "--rows", "0.5", "--quick", "--quiet", "--out", "table"))
    t.contains(result.err, "rho0.5000-T1.360.log is in the way")
    t.equal(t.read("precious"), "mine", "the file that the links lead to")


def files_of_the_kernel(t):
    """Under /proc there are files that are waited for as pipes are."""
    for path in ("/proc/kmsg", "/proc/self/status"):
        if not os.path.exists(path):
            raise Skip("no /proc")
        word = f"error: {path}: is made up by the kernel, not a file that is stored; copy it first\n"
        t.contains(t.expect(2, t.run("run", path)).err, word)
        t.contains(t.expect(3, t.run("analyze", path)).err, word)
        t.deck()
        t.contains(t.expect(3, t.run("sweep", "deck.toml", "--list", path)).err, word)
        (t.dir / "deck.toml").unlink()
        t.deck(('lattice = { type = "fcc", cells = 3 }', f'file = "{path}"'), ("density = 0.8442\n", ""))
        t.contains(t.expect(3, t.run("run", "deck.toml")).err, word)
        t.deck()
        t.run_well("run", "deck.toml", "--quiet", "--out", "out")
        for checkpoint in (t.dir / "out").glob("checkpoint.*"):
            checkpoint.unlink()
            checkpoint.symlink_to(path)
        t.contains(t.expect(6, t.run("resume", "out")).err, "it is empty")
        shutil.rmtree(t.dir / "out")


def plugins_of_the_kernel(t):
    """A folder of plug-ins in which there is something else, as a pipe."""
    os.mkfifo(t.dir / "libOpenMMpipe.so")
    for folder in (t.dir, "/proc", "/dev"):
        t.run_well("info", env={**clean_environment(), "OPENMM_PLUGIN_DIR": str(folder)})


def cases():
    tests = [Case("logs that lead elsewhere", logs_are_not_written_through),
             Case("files of the kernel", files_of_the_kernel), Case("plug-ins of the kernel", plugins_of_the_kernel)]
    for kind in WORDS:
        tests += [Case(f"the record of a run is a {kind}", record_of_a_run(kind)),
                  Case(f"the rows of a run are a {kind}", rows_of_a_run(kind)),
                  Case(f"the records of a sweep are a {kind}", records_of_a_sweep(kind))]
    return tests
