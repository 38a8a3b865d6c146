"""What a parent process leaves to this program, and what this program leaves behind when it is killed."""

import os
import re
import resource
import signal
import subprocess

from compares import needs_openmm
from harness import Case, Failure, Skip, clean_environment
import waiting
from resumes import LONG, end, has_begun, start

SWEEP = ("sweep", "deck.toml", "--grid", "system.temperature=1.2|2.0", "--jobs", "2", "--out", "out")

# Says that it is LAMMPS, and then runs until it is killed.
ENDLESS_LAMMPS = """#!/bin/sh
if [ "$1" = -h ]; then
    echo 'Massively Parallel Simulator - 1 Jan 2030'
    printf 'Installed packages:\\n\\nNONE\\n\\n'
    exit 0
fi
echo $$ >"$HERE/started"
mv "$HERE/started" "$HERE/pid"
exec tail -f /dev/null
"""


def blocked(number):
    """A signal that the parent had blocked stops the run all the same."""
    def test(t):
        t.deck()
        process = start(t, "run", "deck.toml", "--out", "out", *LONG,
                        preexec_fn=lambda: signal.pthread_sigmask(signal.SIG_BLOCK, [number]))
        has_begun(t, process)
        process.send_signal(number)
        t.contains(t.expect(128 + number, end(process)).err, f"by {signal.Signals(number).name}; to go on")
    return test


def ignored(number):
    def test(t):
        t.deck()
        process = start(t, "run", "deck.toml", "--out", "out", *LONG,
                        preexec_fn=lambda: signal.signal(number, signal.SIG_IGN))
        has_begun(t, process)
        process.send_signal(number)
        t.expect(128 + number, end(process))
    return test


def ignored_ends_of_children(t):
    """A parent that wants to know nothing of its children says so for ours, too."""
    t.deck()
    deaf = {"preexec_fn": lambda: signal.signal(signal.SIGCHLD, signal.SIG_IGN)}
    t.run_well(*SWEEP, "--quiet", **deaf)
    t.run_well("reproduce", "verlet1967", "--quick", "--rows", "0.45:2.935", "--out", "table", "--quiet", **deaf)
    (t.dir / "lmp").write_text(ENDLESS_LAMMPS.replace("exec tail -f /dev/null", "exit 3"))
    (t.dir / "lmp").chmod(0o700)
    result = t.run("compare", "deck.toml", "--with", "lammps", "--quiet",
                   env={**clean_environment(), "LJMD_LAMMPS": str(t.dir / "lmp"), "HERE": str(t.dir)}, **deaf)
    t.contains(t.expect(3, result).err, "LAMMPS failed with exit status 3")


def used_up_processor_time(t):
    """The system warns every second; the run needs but the first one."""
    t.deck()
    result = t.run("run", "deck.toml", "--out", "out", "--quiet", "--set", "stage.production.steps=100000000",
                   preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (1, 600)))
    t.contains(t.expect(152, result).err, "by SIGXCPU; to go on: ljmd resume out\n")


def no_room_for_threads_of_lammps(t):
    t.deck()
    (t.dir / "lmp").write_text(ENDLESS_LAMMPS.replace("NONE", "OPENMP").replace(
        "exec tail -f /dev/null", "echo 'libgomp: Thread creation failed: Resource temporarily unavailable'; exit 1"))
    (t.dir / "lmp").chmod(0o700)
    result = t.run("compare", "deck.toml", "--with", "lammps", "--threads", "4", "--quiet",
                   env={**clean_environment(), "LJMD_LAMMPS": str(t.dir / "lmp"), "HERE": str(t.dir)})
    t.golden(t.expect(7, result).err)


def comparison_ended_by(number):
    """Neither LAMMPS nor the folder that it works in is left."""
    def test(t):
        t.deck()
        (t.dir / "lmp").write_text(ENDLESS_LAMMPS)
        (t.dir / "lmp").chmod(0o700)
        scratch = t.dir / "scratch"
        scratch.mkdir()
        process = subprocess.Popen(
            [t.ljmd, "compare", "deck.toml", "--with", "lammps", "--quiet"], cwd=t.dir, stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
            env={**clean_environment(), "LJMD_LAMMPS": str(t.dir / "lmp"), "HERE": str(t.dir), "TMPDIR": str(scratch)})
        waiting.until((t.dir / "pid").exists, "LAMMPS has begun", process)
        lammps = int(t.read("pid"))
        t.check(len(t.files("scratch")) > 1, "LAMMPS has no files")
        process.send_signal(number)
        t.equal(process.wait(timeout=waiting.PATIENCE), -number, "exit code")
        try:
            waiting.until(lambda: not waiting.is_alive(lammps), "LAMMPS has ended")
            waiting.until(lambda: not any(scratch.iterdir()), "its folder is removed")
        finally:
            if waiting.is_alive(lammps):
                os.kill(lammps, signal.SIGKILL)
    return test


def at_most(count):
    """Options: no more processes and threads of this user. Root, whom no such limit binds, becomes nobody; and a sanitizer
    does not look for leaks, for which it needs another process."""
    def limit():
        if os.geteuid() == 0:
            os.setgroups([])
            os.setgid(65534)
            os.setuid(65534)
        resource.setrlimit(resource.RLIMIT_NPROC, (count, count))
    sanitizer = ":".join(filter(None, [os.environ.get("ASAN_OPTIONS"), "detect_leaks=0"]))
    return {"preexec_fn": limit, "env": {**clean_environment(), "ASAN_OPTIONS": sanitizer}}


few_processes = at_most(1)


def needs_few_processes(t):
    t.dir.chmod(0o777)
    try:
        t.run_well("--version", **few_processes)
    except (Failure, subprocess.SubprocessError, OSError) as reason:
        raise Skip(f"the program cannot be run with few processes: {reason}") from reason


def no_room_for_threads_of_openmm(t):
    """OpenMM itself would wait for ever for threads that it has not got."""
    needs_openmm(t)
    needs_few_processes(t)
    t.deck()
    result = t.expect(7, t.run("compare", "deck.toml", "--with", "openmm", "--threads", "4", "--steps", "10", "--quiet",
                               **at_most(5)))
    t.check(re.search(r"\d threads are asked for, and the system allows no more than \d here; ", result.err), result.err)


def no_room_for_threads_or_processes(t):
    t.deck()
    needs_few_processes(t)
    before = t.files()
    for command in ("run", "bench", "check"):
        result = t.expect(7, t.run(command, "deck.toml", "--threads", "40", **few_processes))
        t.check(re.match(r"error: 40 threads are asked for, and the system allows no more than \d+ here; ", result.err),
                f"message of {command}: {result.err}")
        t.equal((result.out, t.files()), ("", before), "stdout and files")
    result = t.expect(7, t.run(*SWEEP, **few_processes))
    t.check(re.match(r"error: cannot start '.*ljmd': the system has no room for another process: .*\n"
                     r"  \d+ ran at a time; --jobs asks for fewer than 2\n$", result.err), f"message: {result.err}")


def cases():
    return [
        Case("a blocked SIGTERM", blocked(signal.SIGTERM)),
        Case("a blocked SIGINT", blocked(signal.SIGINT)),
        Case("an ignored SIGTERM", ignored(signal.SIGTERM)),
        Case("an ignored SIGUSR1", ignored(signal.SIGUSR1)),
        Case("ignored ends of children", ignored_ends_of_children),
        Case("used up processor time", used_up_processor_time),
        Case("a comparison that is killed", comparison_ended_by(signal.SIGKILL)),
        Case("a comparison that is told to end", comparison_ended_by(signal.SIGTERM)),
        Case("a comparison that is quit", comparison_ended_by(signal.SIGQUIT)),
        Case("no room for threads or processes", no_room_for_threads_or_processes),
        Case("no room for threads of OpenMM", no_room_for_threads_of_openmm),
        Case("no room for threads of LAMMPS", no_room_for_threads_of_lammps),
    ]
