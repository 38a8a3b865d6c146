"""Runs that several MPI processes share: the files of one process, byte for byte, and what happens when a process fails.

Usage: mpi_test.py --ljmd PROGRAM [--mpirun PROGRAM] [--ranks N,N] [--threads N,N] [--kills N] CASE...

Cases: decks (every fluid deck of inputs/, made short), shapes, precision, resumed, killed, failing, refused. Without mpirun the test is
skipped, unless LJMD_REQUIRE_PEERS is set.
"""

import argparse
import json
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests"))
sys.path.insert(0, str(ROOT / "tests/cli"))
import decks  # noqa: E402
import keeper  # noqa: E402
import waiting  # noqa: E402
from figures import check, exit_code  # noqa: E402

SKIPPED = 77
TILE = 50
# Words of the end of a run that tell of time, place and the machine.
OF_ONE_RUN = ("run.json", "results.txt", "checkpoint.1", "checkpoint.2", "report.html")

SHAPES = {  # start, temperature
    "elongated": ('lattice = { type = "fcc", cells = 3, layers = 16 }\ndensity = 0.8', 1.0),
    "most tiles without an atom": ('lattice = { type = "fcc", cells = 4, height = 60.0 }\ndensity = 0.8', 0.8),
    "a random start": ('lattice = { type = "random", atoms = 500 }\ndensity = 0.6', 1.0),
    "ranks without a tile": ('lattice = { type = "simple-cubic", cells = 3 }\ndensity = 0.002', 1.5),
}

DECK = """
[system]
{system}
temperature = {temperature}
seed = 5

[potential]
type = "lennard-jones"
cutoff = 2.5
truncation = "shifted"

[neighbors]
tile = {tile}

[[stage]]
name = "hold"
time_step = 0.004
steps = {hold}
temperature = {temperature}
thermostat = {{ type = "stochastic-rescaling" }}

[[stage]]
name = "go"
time_step = 0.004
steps = {steps}
sample = true

[output]
directory = "out"
thermo = {{ every = 5 }}
trajectory = {{ format = "h5md", every = 20, velocities = true }}
checkpoint = {{ every = {checkpoint} }}

[analysis]
rdf = {{ every = 10 }}
"""


def deck_of(system='lattice = { type = "fcc", cells = 5 }\ndensity = 0.8442', temperature=1.0, tile=TILE, hold=40, steps=60,
            checkpoint="\"1 h\""):
    return DECK.format(system=system, temperature=temperature, tile=tile, hold=hold, steps=steps, checkpoint=checkpoint)


class Test:
    def __init__(self, options, folder):
        self.options = options
        self.folder = folder
        self.number = 0

    def new(self, name=""):
        self.number += 1
        return self.folder / f"{self.number}{name}"

    def command(self, ranks, *arguments):
        launcher = [] if ranks == 0 else [self.options.mpirun, "--oversubscribe", "-n", ranks]
        return [str(each) for each in (*launcher, self.options.ljmd, *arguments)]

    def run(self, ranks, *arguments, **more):
        """0 ranks: without mpirun."""
        return subprocess.run(self.command(ranks, *arguments), capture_output=True, text=True, timeout=waiting.PATIENCE, cwd=self.folder,
                              stdin=subprocess.DEVNULL, check=False, **more)

    def well(self, ranks, *arguments):
        done = self.run(ranks, *arguments)
        check(f"exit code of {ranks} ranks: {' '.join(map(str, arguments))[:60]}", done.returncode, 0, 0)
        if done.returncode != 0:
            print(done.stderr[-2000:], file=sys.stderr)
        return done

    def written(self, text):
        deck = self.new(".toml")
        deck.write_text(text, encoding="utf-8")
        return deck

    def same(self, what, expected, found):
        """All files but those that tell of one run alone."""
        names = sorted(path.name for path in expected.iterdir() if path.name not in OF_ONE_RUN)
        for name in names:
            there = found / name
            same = there.exists() and there.read_bytes() == (expected / name).read_bytes()
            check(f"{what}: {name} has the bytes of one process", int(same), 1, 0)
        check(f"{what}: there is a table", int("thermo.csv" in names), 1, 0)

    def rows(self, directory):
        return (directory / "thermo.csv").read_text(encoding="utf-8").count("\n")


def compare(t, what, deck, *settings):
    alone = t.new()
    t.well(0, "run", deck, "--quiet", "--out", alone, *settings)
    for ranks in t.options.ranks:
        for threads in t.options.threads:
            shared = t.new()
            t.well(ranks, "run", deck, "--quiet", "--out", shared, "--threads", threads, *settings)
            t.same(f"{what}, {ranks} ranks of {threads} threads", alone, shared)
            shutil.rmtree(shared, ignore_errors=True)
    return alone


def case_decks(t):
    for path in decks.decks():
        if decks.is_few_body(path) or "[force]" in path.read_text(encoding="utf-8"):
            continue
        text = path.read_text(encoding="utf-8")
        settings = [*decks.shortened(text), "--set", f"neighbors.tile={TILE}"]
        if "file = " in text:
            start = t.new()
            other = ROOT / "inputs/examples/canonical.toml"
            t.well(0, "run", other, "--quiet", "--out", start, *decks.shortened(other.read_text(encoding="utf-8")))
            settings += ["--set", f"system.file={start}"]
        compare(t, path.stem, path, *settings)


def case_shapes(t):
    for name, (system, temperature) in SHAPES.items():
        compare(t, name, t.written(deck_of(system=system, temperature=temperature)))


def case_precision(t):
    compare(t, "mixed precision", t.written(deck_of()), "--precision", "mixed")
    compare(t, "a list for 10 steps", t.written(deck_of()), "--set", "neighbors.every=10")


def case_resumed(t):
    """Stopped by a signal to mpirun or by the wall time; any other number of ranks goes on."""
    deck = t.written(deck_of(steps=20000))
    alone = t.new()
    t.well(0, "run", deck, "--quiet", "--out", alone)
    turns = [*t.options.ranks, 0]
    shared = t.new()
    done = t.run(turns[0], "run", deck, "--quiet", "--out", shared, "--walltime", "1e-9s")
    check("a run at the end of its wall time: exit code", done.returncode, 75, 0)
    check("it says how to go on", int("to go on: ljmd resume" in done.stderr), 1, 0)
    for ranks in turns[1:]:
        child = subprocess.Popen(t.command(ranks, "resume", shared, "--quiet"), stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                 text=True, cwd=t.folder)
        before = t.rows(shared)
        waiting.until(lambda: t.rows(shared) >= before + 20, "twenty more rows", child)
        child.send_signal(signal.SIGUSR1)
        _, said = child.communicate(timeout=waiting.PATIENCE)
        check(f"resumed by {ranks} ranks and stopped: exit code", child.returncode, 128 + signal.SIGUSR1, 0)
        check("it says by what", int("SIGUSR1" in said), 1, 0)
    t.well(turns[1], "resume", shared, "--quiet")
    t.same("a run of many parts", alone, shared)


def processes_of(folder):
    """Processes of ours that are left, by the directory that they work in."""
    found = []
    for entry in Path("/proc").glob("[0-9]*"):
        try:
            if (entry / "cwd").resolve() == folder.resolve() and b"ljmd" in (entry / "cmdline").read_bytes():
                found.append(int(entry.name))
        except OSError:
            continue
    return found


def ranks_of(pid, program):
    """Processes below a launcher that run the program."""
    found = []
    for entry in Path("/proc").glob("[0-9]*"):
        try:
            parent = int(re.search(r"^PPid:\s+(\d+)", (entry / "status").read_text(), flags=re.M).group(1))
            if parent == pid and (entry / "exe").resolve() == program:
                found.append(int(entry.name))
        except OSError:
            continue
    return sorted(found)


def kill(victim):
    """Whether there was still something to kill: a rank may end at that moment."""
    try:
        if victim is not None:
            os.kill(victim, signal.SIGKILL)
        return victim is not None
    except ProcessLookupError:
        return False


def case_killed(t):
    generator = random.Random(11)
    deck = t.written(deck_of(steps=4000, checkpoint=200))
    alone = t.new()
    t.well(0, "run", deck, "--quiet", "--out", alone)
    program = Path(t.options.ljmd).resolve()
    killed = 0
    for turn in range(t.options.kills):
        ranks = t.options.ranks[turn % len(t.options.ranks)]
        shared = t.new()
        place = t.folder / f"kill{turn}"
        place.mkdir()
        child = subprocess.Popen(t.command(ranks, "run", deck, "--quiet", "--out", shared), stdout=subprocess.DEVNULL,
                                 stderr=subprocess.PIPE, text=True, cwd=place)
        rows = generator.randrange(1, 500)
        waiting.until(lambda: child.poll() is not None or (shared / "thermo.csv").exists() and t.rows(shared) >= rows,
                      "so many rows, or the end of the run")
        victims = ranks_of(child.pid, program)
        victim = generator.choice(victims) if victims else None
        killed += kill(victim)
        child.communicate(timeout=waiting.PATIENCE)
        finished = json.loads((shared / "run.json").read_text(encoding="utf-8"))["finished"] is True
        check(f"kill {turn}: it ends with an error, or had been at its end", int(child.returncode != 0 or finished), 1, 0)
        waiting.until(lambda: not processes_of(place), f"kill {turn}: no process is left")
        others = [each for each in (0, *t.options.ranks) if each != ranks]
        if not finished:
            if any(shared.glob("checkpoint.*")):
                t.well(generator.choice(others), "resume", shared, "--quiet")
            else:
                t.well(generator.choice(others), "run", deck, "--quiet", "--force", "--out", shared)
        t.same(f"kill {turn}", alone, shared)
        shutil.rmtree(shared, ignore_errors=True)
    check("runs killed, most of them before their end", killed, t.options.kills, t.options.kills / 5)


def told_once(done, words):
    check(f"told once: {words}", done.stderr.count(words), 1, 0)


def case_failing(t):
    ranks = t.options.ranks[0]
    # All ranks find that it blows up.
    deck = t.written(deck_of().replace('time_step = 0.004\nsteps = 60', 'time_step = 0.5\nsteps = 2000'))
    done = t.run(ranks, "run", deck, "--quiet", "--force")
    check("a run that blows up: exit code", done.returncode, 5, 0)
    told_once(done, "the run has blown up")
    check("its last configuration is kept", int((t.folder / "out/failed.xyz").exists()), 1, 0)
    alone = t.run(0, "run", deck, "--quiet", "--force", "--out", "alone")
    check("it is that of one process", int((t.folder / "out/failed.xyz").read_bytes() == (t.folder / "alone/failed.xyz").read_bytes()), 1, 0)
    ours = [line for line in done.stderr.splitlines() if "blown up" in line]
    theirs = [line.replace("alone", "out") for line in alone.stderr.splitlines() if "blown up" in line]
    check("it says what one process says", int(ours == theirs and ours != []), 1, 0)
    # Rank 0 cannot write.
    script = t.new(".sh")
    script.write_text(f'#!/bin/bash\nif [ "${{OMPI_COMM_WORLD_RANK:-$PMI_RANK}}" = 0 ]; then ulimit -f 60; fi\n'
                      f'exec {t.options.ljmd} run {t.written(deck_of(steps=5000))} --quiet --out {t.new()}\n', encoding="utf-8")
    script.chmod(0o755)
    # Messages through sockets: the library's own files in memory would meet the limit first.
    limited = subprocess.run([t.options.mpirun, "--oversubscribe", "-n", str(ranks), script], capture_output=True, text=True,
                             timeout=waiting.PATIENCE, cwd=t.folder, check=False,
                             env={**os.environ, "OMPI_MCA_btl": "self,tcp", "PMIX_MCA_gds": "hash"})
    check("a full disk: exit code", limited.returncode, 4, 0)
    told_once(limited, "error: ")


def case_refused(t):
    ranks = t.options.ranks[0]
    good = t.written(deck_of())
    for command, code, words in (
            (("sweep", good, "--grid", "system.density=0.7|0.8"), 2, "shares no work"),
            (("run", t.written(deck_of().replace("cutoff = 2.5", "cutof = 2.5"))), 2, "cutof"),
            (("run", t.folder / "absent.toml"), 2, "absent.toml"),
            (("run", ROOT / "inputs/fewbody/pendulum.toml", "--out", t.new()), 2, "few bodies"),
            (("run", good, "--set", 'neighbors.method="cells"', "--set", "neighbors.tile=50", "--out", t.new()), 2, "error"),
            (("resume", t.folder / "nowhere"), 3, "nowhere"),
            (("run", good, "--bogus"), 2, "--bogus")):
        done = t.run(ranks, *command)
        check(f"{command[0]} {Path(str(command[1])).name}: exit code", done.returncode, code, 0)
        check(f"it is told once: {words}", done.stderr.count("error: ") - done.stderr.count("errors: "), 1, 0)
        check(f"in these words: {words}", int(words in done.stderr), 1, 0)
    # Ranks that read different decks.
    one, other = t.written(deck_of()), t.written(deck_of(temperature=1.1))
    script = t.new(".sh")
    script.write_text(f'#!/bin/sh\nif [ "${{OMPI_COMM_WORLD_RANK:-$PMI_RANK}}" = 0 ]; then D={one}; else D={other}; fi\n'
                      f'exec {t.options.ljmd} run "$D" --quiet --out {t.new()}\n', encoding="utf-8")
    script.chmod(0o755)
    done = subprocess.run([t.options.mpirun, "--oversubscribe", "-n", "2", script], capture_output=True, text=True, timeout=waiting.PATIENCE,
                          cwd=t.folder, check=False)
    check("decks that differ: exit code", int(done.returncode in (2, 8)), 1, 0)
    told_once(done, "another deck than rank 0")
    # Ranks that work in different folders, where a relative path leads to different start files and checkpoints.
    deck = t.written(deck_of(system='file = "start.xyz"', checkpoint=20))
    folders = [t.new(), t.new()]
    for folder, seed in zip(folders, (1, 2)):
        t.well(0, "run", good, "--set", f"system.seed={seed}", "--set", "stage.go.steps=10", "--quiet", "--out", folder)
        shutil.copy(folder / "final.xyz", folder / "start.xyz")
    apart = t.new(".sh")
    apart.write_text(f'#!/bin/sh\nif [ "${{OMPI_COMM_WORLD_RANK:-$PMI_RANK}}" = 0 ]; then cd {folders[0]}; else cd {folders[1]}; fi\n'
                     f'exec {t.options.ljmd} "$@" --quiet\n', encoding="utf-8")
    apart.chmod(0o755)

    def run_apart(*arguments):
        return subprocess.run([t.options.mpirun, "--oversubscribe", "-n", "2", apart, *arguments], capture_output=True, text=True,
                              timeout=waiting.PATIENCE, cwd=t.folder, check=False)

    out = t.new()
    done = run_apart("run", deck, "--out", out)
    check("start files that differ: exit code", int(done.returncode in (2, 8)), 1, 0)
    told_once(done, "1 of 2 ranks read another start file than rank 0")
    check("start files that differ: nothing is written", int(out.exists()), 0, 0)
    shutil.copy(folders[0] / "start.xyz", folders[1])
    check("start files that are the same: exit code", run_apart("run", deck, "--out", out).returncode, 0, 0)
    t.well(0, "run", good, "--quiet", "--out", folders[0] / "run")
    shutil.copytree(folders[0] / "run", folders[1] / "run")
    max((folders[1] / "run").glob("checkpoint.*"), key=lambda path: path.stat().st_mtime_ns).unlink()
    done = run_apart("resume", "run")
    check("checkpoints that differ: exit code", int(done.returncode in (2, 8)), 1, 0)
    told_once(done, "1 of 2 ranks read another checkpoint than rank 0")
    # Without its part for MPI, and in a job of Slurm without mpirun.
    copy = t.new("copy")
    copy.mkdir()
    shutil.copy(t.options.ljmd, copy / "ljmd")
    done = subprocess.run([t.options.mpirun, "--oversubscribe", "-n", "2", copy / "ljmd", "run", good, "--quiet", "--out", t.new()],
                          capture_output=True, text=True, timeout=waiting.PATIENCE, cwd=t.folder, check=False)
    check("without its part for MPI: exit code", done.returncode, 2, 0)
    check("it says so", int("without MPI" in done.stderr), 1, 0)
    done = t.run(0, "run", good, "--quiet", "--out", t.new(), env={**os.environ, "SLURM_NTASKS": "4", "SLURM_PROCID": "1"})
    check("variables of Slurm alone are no sign of MPI", done.returncode, 0, 0)
    # A launcher with PMIx that starts one process, and tells its rank alone.
    for command in (("run", good, "--quiet"), ("sweep", good, "--grid", "system.density=0.7|0.8", "--set", "stage.go.steps=5")):
        done = t.run(0, *command, "--out", t.new(), env={**os.environ, "PMIX_RANK": "0"})
        check(f"{command[0]} of one process that a launcher has started: exit code", done.returncode, 0, 0)


def case_processors(t):
    """Ranks whose processors, libraries or settings differ: what decides bits is agreed on, or the run is refused."""
    deck = t.written(deck_of(steps=20))
    with_fma = "avx2" in Path("/proc/cpuinfo").read_text(encoding="utf-8")
    if not with_fma:
        return

    def run(directory, *commands, **environment):
        """Rank k gets the k-th of the commands' options and variables."""
        parts = []
        for options, variables in commands:
            parts += [":"] * bool(parts) + ["-n", "1", *[word for each in variables for word in ("-x", each)], t.options.ljmd, *options]
        words = [str(each) for each in (t.options.mpirun, "--oversubscribe", *parts)]
        return subprocess.run(words, capture_output=True, text=True, timeout=waiting.PATIENCE, cwd=t.folder, check=False,
                              env={**os.environ, **environment})

    def options(directory, *more):
        return ("run", deck, "--quiet", "--out", directory, *more)

    alone = t.new()
    t.well(0, *options(alone, "--simd", "x86-64-v3"))
    lower = t.new()
    done = run(lower, (options(lower), ()), (options(lower), ("LJMD_SIMD=x86-64-v3",)))
    check("a level asked for at one rank: exit code", done.returncode, 0, 0)
    t.same("a level asked for at one rank", alone, lower)
    if "avx512bw" in Path("/proc/cpuinfo").read_text(encoding="utf-8"):
        told_once(done, "all compute with x86-64-v3")
    for what, second, words in (
            ("levels that differ", (("--simd", "x86-64-v2"), ()), "is asked for at one rank"),
            ("a C library without FMA", ((), ("GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-AVX2_Usable,-FMA_Usable,-AVX2,-FMA4",)),
             "the C library's exp, log")):
        out = t.new()
        done = run(out, (options(out, "--simd", "x86-64-v3"), ()), (options(out, *second[0]), second[1]))
        check(f"{what}: exit code", int(done.returncode in (2, 8)), 1, 0)
        told_once(done, words)
        check(f"{what}: nothing is written", int(out.exists()), 0, 0)


CASES = {name[5:]: function for name, function in list(globals().items()) if name.startswith("case_")}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--ljmd", required=True)
    parser.add_argument("--mpirun", default=shutil.which("mpirun"))
    numbers = lambda text: [int(each) for each in text.split(",")]  # noqa: E731
    parser.add_argument("--ranks", type=numbers, default=[2, 3])
    parser.add_argument("--threads", type=numbers, default=[1])
    parser.add_argument("--kills", type=int, default=3)
    parser.add_argument("cases", nargs="*", choices=[*CASES, []])
    options = parser.parse_args()
    if options.mpirun is None or not (Path(options.ljmd).resolve().parent / "ljmd_mpi.so").exists():
        print("no mpirun, or a program without MPI")
        return 1 if os.environ.get("LJMD_REQUIRE_PEERS") == "1" else SKIPPED
    os.environ.update({"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_mpi_yield_when_idle": "1",
                       "OMP_NUM_THREADS": "1"})
    options.ljmd = str(Path(options.ljmd).resolve())
    os.environ["OMPI_MCA_btl_vader_backing_directory"] = tempfile.gettempdir()
    for name in options.cases or CASES:
        with tempfile.TemporaryDirectory() as folder:
            CASES[name](Test(options, Path(folder)))
    return exit_code()


if __name__ == "__main__":
    # A killed rank leaves its part of the shared memory behind: in the folder that is removed, and that is in memory.
    if os.access("/dev/shm", os.W_OK):
        tempfile.tempdir = "/dev/shm"
    sys.exit(keeper.kept(main))
