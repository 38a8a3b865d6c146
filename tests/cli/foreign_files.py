"""Files that are not the program's own, or are those of an earlier run: what stays as it is, whatever its name."""

import os
import resource
import shutil
import signal
import subprocess

from harness import DECK, Case, Skip, check_same_run, clean_environment, snapshot
import waiting

FRAMES = ("thermo = { every = 5 }",
          'thermo = { every = 5 }\ntrajectory = { format = "h5md", every = 5 }\ncheckpoint = { every = 10 }')
LONG = ("steps = 40", "steps = 20000")
SWEEP = ("sweep", "deck.toml", "--grid", "system.density=0.8|0.85", "--jobs", "1", "--quiet", "--out", "out")
NOBODY = 65534


def start(t, *arguments):
    return subprocess.Popen([t.ljmd, *arguments, "--quiet"], cwd=t.dir, env=clean_environment(),
                            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)


def same_files(t, found, expected, what):
    different = [name for name in sorted({*found, *expected}) if found.get(name) != expected.get(name)]
    t.equal(different, [], f"{what} that are not as they were")


def stop_when(process, path):
    """Let a process wait as soon as a file is there."""
    waiting.until(path.exists, f"there is {path}", process)
    process.send_signal(signal.SIGSTOP)
    waiting.until_stopped(process)


def names_that_look_temporary(t):
    """A run, stopped and resumed, and an export leave files of such names alone, even where one is the deck."""
    (t.dir / "out").mkdir()
    mine = [f"out/{name}{end}" for name in ("results.json", "final.xyz", "checkpoint.1", "trajectory.h5md", "start.xyz")
            for end in (".tmp", "~")]
    for name in mine + ["out/start.tmp.h5md"]:
        (t.dir / name).write_text("mine")
    t.deck(FRAMES, name="out/run.json.tmp")
    deck = t.read("out/run.json.tmp")
    t.expect(75, t.run("run", "out/run.json.tmp", "--out", "out", "--quiet", "--walltime", "0.000001s"))
    t.run_well("resume", "out", "--quiet")
    for target in ("h5md", "extxyz"):
        t.run_well("export", "out", "--to", target, "--out", "out")
    for name in mine:
        t.equal(t.read(name), "mine", name)
    t.equal(t.read("out/run.json.tmp"), deck, "the deck")
    t.equal([name for name in t.files("out") if name.startswith(".")], [], "files left over")


def exports_follow_no_link(t):
    t.deck()
    (t.dir / "precious").write_text("mine")
    (t.dir / "x").mkdir()
    for name in ("start.tmp.h5md", "start.h5md", "start.xyz", "start.xyz.tmp"):
        (t.dir / "x" / name).symlink_to(t.dir / "precious")
    for target in ("h5md", "extxyz"):
        t.run_well("export", "deck.toml", "--to", target, "--out", "x", "--force")
    t.equal(t.read("precious"), "mine", "what the links lead to")
    t.check(not (t.dir / "x/start.h5md").is_symlink(), "start.h5md is still a link")
    t.check((t.dir / "x/start.tmp.h5md").is_symlink(), "start.tmp.h5md is no link any more")


def exports_into_one_directory(t):
    """Programs that write the same files at the same time: each file is whole, and no program fails."""
    t.deck()
    t.run_well("export", "deck.toml", "--to", "extxyz", "--out", "alone")
    programs = [start(t, "export", "deck.toml", "--to", target, "--out", "x", "--force")
                for target in ("extxyz", "h5md", "lammps") * 4]
    talk = [program.communicate(timeout=waiting.PATIENCE)[1] for program in programs]
    t.equal([program.returncode for program in programs], [0] * 12, f"exit codes; {''.join(talk)}")
    t.equal(t.read("x/start.xyz"), t.read("alone/start.xyz"), "start.xyz")
    t.equal(t.files("x"), ["in.lammps", "start.data", "start.h5md", "start.xyz"], "files")


def stand_in_for(t, kind, foreign):
    """Move the directory `out` away, and let another one stand at its path."""
    (t.dir / "out").rename(t.dir / "moved")
    if kind == "link":
        (t.dir / "out").symlink_to(t.dir / foreign)
    else:
        (t.dir / foreign).rename(t.dir / "out")


def a_run_goes_where_its_directory_is(kind, resumed):
    def test(t):
        t.deck(FRAMES, LONG)
        t.run_well("run", "deck.toml", "--out", "whole", "--quiet")
        t.run_well("run", "deck.toml", "--out", "foreign", "--quiet", "--set", "system.seed=8", "--set",
                   "stage.production.steps=40")
        before = snapshot(t.dir / "foreign")
        if resumed:
            t.expect(75, t.run("run", "deck.toml", "--out", "out", "--quiet", "--walltime", "0.000001s"))
            (t.dir / "out/results.json").unlink(missing_ok=True)
        process = start(t, *(("resume", "out") if resumed else ("run", "deck.toml", "--out", "out")))
        try:
            stop_when(process, t.dir / "out/checkpoint.1")  # the second one of the run, the first one of a resumed run
            stand_in_for(t, kind, "foreign")
            process.send_signal(signal.SIGCONT)
            _, talk = process.communicate(timeout=waiting.PATIENCE)
        finally:
            process.kill()
        t.equal(process.returncode, 0, f"exit code; {talk}")
        t.contains(talk, "warning: out was moved or replaced during the run")
        same_files(t, snapshot(t.dir / "out"), before, "what stands at the old path")
        check_same_run(t.dir / "moved", t.dir / "whole")
    return test


def a_sweep_ends_when_its_directory_is_moved(t):
    t.deck(LONG)
    t.run_well(*SWEEP[:-1], "foreign", "--set", "stage.production.steps=40")
    before = snapshot(t.dir / "foreign")
    process = start(t, *SWEEP)
    try:
        stop_when(process, t.dir / "out/points/density=0.8/run.json")
        stand_in_for(t, "directory", "foreign")
        process.send_signal(signal.SIGCONT)
        _, talk = process.communicate(timeout=waiting.PATIENCE)
    finally:
        process.kill()
    t.equal(process.returncode, 9, f"exit code; {talk}")
    t.contains(talk, "error: 'out' is not the directory any more that it was")
    same_files(t, snapshot(t.dir / "out"), before, "what stands at the old path")
    (t.dir / "out").rename(t.dir / "foreign")
    (t.dir / "moved").rename(t.dir / "out")
    t.run_well(*SWEEP)


def a_table_is_not_reproduced_over_a_run(t):
    t.deck()
    t.run_well("run", "deck.toml", "--out", "out", "--quiet")
    (t.dir / "mine").mkdir()
    (t.dir / "mine/results.json").write_text("mine")
    before = snapshot(t.dir)
    reproduce = ("reproduce", "verlet1967", "--quick", "--rows", "0.5", "--out")
    for options in ((), ("--force",)):
        result = t.expect(2, t.run(*reproduce, "out", *options))
        t.contains(result.err, "error: out is the directory of a run, whose files stay as they are. Nothing was run.\n")
    t.contains(t.expect(2, t.run(*reproduce, "mine")).err, "error: mine/results.json is there already. Nothing was run.\n")
    same_files(t, snapshot(t.dir), before, "files")


def a_comparison_replaces_no_table(t):
    t.deck(text=DECK)
    (t.dir / "out").mkdir()
    for name in ("compare-lammps-rdf.csv", "compare-lammps.json"):
        (t.dir / "out" / name).write_text("mine")
        result = t.expect(2, t.run("compare", "deck.toml", "--with", "lammps", "--out", "out"))
        t.contains(result.err, f"error: out/{name} is there already. Nothing was compared.\n")
        t.equal(t.read(f"out/{name}"), "mine", name)
        (t.dir / "out" / name).unlink()


def linked_points_are_refused(t):
    """With --force, too: what is behind a link belongs to somebody else."""
    t.deck()
    t.run_well("run", "deck.toml", "--out", "foreign", "--quiet")
    t.run_well(*SWEEP)
    point = t.dir / "out/points/density=0.8"
    point.rename(t.dir / "point")
    point.symlink_to(t.dir / "foreign")
    before = snapshot(t.dir)
    for options in ((), ("--force",), ("--force", "--set", "system.seed=9")):
        result = t.expect(2, t.run(*SWEEP, *options))
        t.equal(result.err, "error: out/points/density=0.8 is in the way: a run is made there, and it is a link. "
                            "Nothing was run.\n", "stderr")
    (t.dir / "out/points").rename(t.dir / "points")
    (t.dir / "out/points").symlink_to(t.dir / "points")
    t.contains(t.expect(2, t.run(*SWEEP, "--force")).err, "out/points is in the way: ")
    (t.dir / "out/points").unlink()
    (t.dir / "points").rename(t.dir / "out/points")
    same_files(t, snapshot(t.dir), before, "files")


def directories_in_the_way_stay(t):
    """Empty ones, too: --force removes files of an earlier run alone."""
    t.deck()
    for name in ("out/thermo.csv", "out/checkpoint.1"):
        (t.dir / name).mkdir(parents=True)
        result = t.expect(2, t.run("run", "deck.toml", "--out", "out", "--force"))
        t.contains(result.err, f"error: {name} is in the way: a file of that name is to be written, and this is no file.")
        (t.dir / name).rmdir()
    t.run_well(*SWEEP)
    point = t.dir / "out/points/density=0.8"
    for path in point.iterdir():
        path.unlink()
    t.run_well("sweep", "deck.toml", "--grid", "system.density=0.7|0.75", *SWEEP[4:], "--force")
    t.check(point.is_dir(), "the empty directory was removed")


def a_replacement_that_fails(t):
    """What fails before the new run has a checkpoint, costs nothing of the earlier one."""
    t.deck(FRAMES)
    t.run_well("run", "deck.toml", "--out", "out", "--quiet")
    before = snapshot(t.dir / "out")
    again = ("run", "deck.toml", "--out", "out", "--quiet", "--force")
    for limit in (0, 100, 2000, 6000, 20_000):
        t.expect(4, t.run(*again, preexec_fn=lambda size=limit: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))))
        same_files(t, snapshot(t.dir / "out"), before, f"files with room for {limit} bytes")
    t.run_well(*again, "--set", "system.seed=8")
    t.equal(sorted(t.files("out")), sorted(before), "files of the new run")
    t.check((t.dir / "out/final.xyz").read_bytes() != before["final.xyz"], "the earlier run was not replaced")


def a_sweep_that_cannot_be_replaced(t):
    t.deck()
    t.run_well(*SWEEP)
    (t.dir / "out/points/density=0.85/trajectory.xyz/mine").mkdir(parents=True)
    before = snapshot(t.dir / "out")
    result = t.expect(2, t.run(*SWEEP, "--force", "--set", "system.seed=9"))
    t.contains(result.err, "out/points/density=0.85/trajectory.xyz is in the way")
    same_files(t, snapshot(t.dir / "out"), before, "files")


def as_nobody():
    os.setgroups([])
    os.setgid(NOBODY)
    os.setuid(NOBODY)


def a_directory_that_may_not_be_listed(t):
    """One of mode 1733: files may be put into it, but not looked for. Others run a copy of the program: the folder of the
    build may be one that they cannot enter."""
    if os.geteuid() != 0:
        raise Skip("only root can be somebody else")
    t.dir.chmod(0o755)
    t.deck(FRAMES)
    t.ljmd = shutil.copy(t.ljmd, t.dir / "ljmd")
    try:
        t.run_well("check", "deck.toml", preexec_fn=as_nobody)
    except (OSError, subprocess.SubprocessError) as reason:
        raise Skip(f"others may not enter the folder for temporary files: {reason}") from reason
    (t.dir / "drop").mkdir()
    (t.dir / "drop").chmod(0o1733)
    for out in ("drop/out", "drop"):
        t.expect(0, t.run("run", "deck.toml", "--quiet", "--out", out, preexec_fn=as_nobody))
        t.check((t.dir / out / "results.json").exists(), f"{out} has no results")


def long_paths(t):
    """Near the longest path that the system takes a run is refused before it begins, or comes to its end."""
    t.deck(FRAMES)
    folder = "/".join(["d" * 199] * 19)
    for length, code in ((3900, 0), (4020, 0), (4040, 2), (4080, 2), (4094, 2), (4200, 2)):
        out = folder + "/" + "e" * 150 + "/" + "f" * (length - len(folder) - 152)
        result = t.expect(code, t.run("run", "deck.toml", "--quiet", "--out", out))
        if code != 0:
            t.contains(result.err, " is too long: files in it cannot be named. Nothing was run.\n")
            t.check(not any(name.endswith("f") and len(name) == length for name in t.files()), "there is a directory")


def cases():
    tests = [Case(test.__name__.replace("_", " "), test)
             for test in (names_that_look_temporary, exports_follow_no_link, exports_into_one_directory,
                          a_sweep_ends_when_its_directory_is_moved, a_table_is_not_reproduced_over_a_run,
                          a_comparison_replaces_no_table, linked_points_are_refused, directories_in_the_way_stay,
                          a_replacement_that_fails, a_sweep_that_cannot_be_replaced, a_directory_that_may_not_be_listed,
                          long_paths)]
    for kind in ("directory", "link"):
        for resumed in (False, True):
            what = "resumed" if resumed else "begun"
            tests.append(Case(f"a run that was {what} goes where its directory is, with a {kind} in its place",
                              a_run_goes_where_its_directory_is(kind, resumed)))
    return tests
