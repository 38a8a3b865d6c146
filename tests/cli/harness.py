"""What the tests of the program share: a case runs ljmd in an empty directory of its own and looks at what comes out.

A test module has a function cases() that returns a list of Case. Golden files hold the exact text that a person sees,
one file a module, one section a case.
"""

import contextlib
import fcntl
import json
import os
import pty
import re
import select
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Callable

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import keeper  # noqa: E402
import waiting  # noqa: E402

DECK = """\
title = "small"

[system]
lattice = { type = "fcc", cells = 3 }
density = 0.8442
temperature = 1.0
seed = 7

[potential]
type = "lennard-jones"
cutoff = 2.5
truncation = "cut"
tail = true

[neighbors]
skin = 0.3

[[stage]]
name = "melt"
time_step = 0.004
steps = 20
thermostat = { type = "rescale", every = 5 }

[[stage]]
name = "production"
time_step = 0.004
steps = 40
sample = true

[output]
thermo = { every = 5 }
"""

STARS = """\
title = "stars"

[force]
type = "newtonian-gravity"
gravitational_constant = 1.0
softening = 0.0

[[body]]
mass = 3.0
position = [-1.0, 0.0]
velocity = [0.0, -0.5]

[[body]]
mass = 1.5
position = [2.0, 0.0]
velocity = [0.0, 1.0]

[[stage]]
name = "orbits"
time_step = 0.01
steps = 100

[output]
thermo = { every = 10 }
"""

ARGON = """\
[argon]
sigma = "3.405 angstrom"
epsilon = "119.8 K"
mass = "39.948 u"
"""


class Failure(Exception):
    """A case found the program at fault."""


class Skip(Exception):
    """A case cannot be tried on this machine."""


@dataclass
class Case:
    name: str
    test: Callable


@dataclass
class Result:
    code: int
    out: str
    err: str


class GoldenFile:
    """Sections "=== name" and, below each, the text."""

    def __init__(self, path, update):
        self.path, self.update, self.used = path, update, {}
        self.sections = {}
        text = path.read_text(encoding="utf-8") if path.exists() else ""
        for name, body in re.findall(r"^=== (.*)\n((?:(?!=== ).*\n?)*)", text, flags=re.M):
            self.sections[name] = body

    def compare(self, name, text):
        text = text if text.endswith("\n") or not text else text + "\n"
        self.used[name] = text
        if not self.update and self.sections.get(name) != text:
            raise Failure(f"differs from {self.path.name}\n  expected:\n{indent(self.sections.get(name, '(nothing)'))}"
                          f"\n  found:\n{indent(text)}")

    def finish(self):
        """@return what is wrong with the file as a whole"""
        if self.update and self.used:
            self.path.parent.mkdir(exist_ok=True)
            self.path.write_text("".join(f"=== {name}\n{text}" for name, text in self.used.items()), encoding="utf-8")
            return []
        return [f"{self.path.name}: no case has the name '{name}'" for name in self.sections if name not in self.used]


def indent(text):
    return "\n".join("    " + line for line in text.splitlines())


class Context:
    """One case: a fresh directory and the means to run ljmd in it."""

    def __init__(self, ljmd, directory, golden):
        self.ljmd, self.dir, self.golden = str(ljmd), Path(directory), golden

    def run(self, *arguments, **options):
        """Run ljmd with these arguments. Options are those of subprocess.run."""
        return self.command([self.ljmd, *map(str, arguments)], **options)

    def shell(self, script):
        """Run a line of shell; "$LJMD" is the program."""
        return self.command(["/bin/sh", "-c", script], env={**clean_environment(), "LJMD": self.ljmd})

    def command(self, command, **options):
        options = {"cwd": self.dir, "capture_output": True, "stdin": subprocess.DEVNULL, "timeout": waiting.PATIENCE,
                   "env": clean_environment(), **options}
        try:
            done = subprocess.run(command, check=False, **options)
        except subprocess.TimeoutExpired as late:
            raise Failure(f"hangs: {' '.join(map(str, command))}") from late
        return Result(done.returncode, decoded(done.stdout), decoded(done.stderr))

    def run_well(self, *arguments, **options):
        """Run ljmd; it must exit with 0."""
        return self.expect(0, self.run(*arguments, **options))

    def expect(self, code, result):
        if result.code != code:
            raise Failure(f"exit code {result.code}, expected {code}; stderr:\n{indent(result.err)}")
        return result

    def deck(self, *replacements, text=DECK, name="deck.toml"):
        """Write a deck, with (old, new) replaced in its text; returns its name."""
        (self.dir / name).write_text(replaced(text, *replacements), encoding="utf-8")
        return name

    def json(self, path):
        return json.loads(self.read(path))

    def read(self, path):
        return (self.dir / path).read_bytes().decode()

    def columns(self, path):
        """A CSV file as header -> list of numbers; empty fields are None."""
        header, *rows = [line.split(",") for line in self.read(path).splitlines()]
        self.check(all(len(row) == len(header) for row in rows), f"{path}: rows of unequal length")
        return {name: [float(row[k]) if row[k] else None for row in rows] for k, name in enumerate(header)}

    def check(self, condition, what):
        if not condition:
            raise Failure(what)

    def equal(self, found, expected, what):
        if found != expected:
            raise Failure(f"{what}: found {found!r}, expected {expected!r}")

    def contains(self, text, part):
        if part not in text:
            raise Failure(f"{part!r} is missing in:\n{indent(text)}")

    def files(self, path="."):
        """Names of all files and directories below a directory."""
        top = self.dir / path
        return sorted(os.path.relpath(os.path.join(folder, name), top)
                      for folder, folders, files, _ in os.fwalk(top) for name in folders + files)  # also where paths are too long


def decoded(data):
    return data.decode("utf-8", errors="backslashreplace") if data is not None else ""


def compare_refused(text, *arguments):
    """A case: `ljmd compare` of a deck is refused with a golden message, and nothing is written."""
    def test(t):
        t.deck(text=text)
        result = t.expect(2, t.run("compare", "deck.toml", "--out", "out", *arguments))
        t.equal(result.out, "", "stdout")
        t.equal(t.files(), ["deck.toml"], "files")
        t.golden(result.err)
    return test


def replaced(text, *replacements):
    """The text of a deck with each (old, new) replaced; every old must stand in it once."""
    for old, new in replacements:
        if text.count(old) != 1:
            raise AssertionError(f"the test's deck holds {old!r} {text.count(old)} times")
        text = text.replace(old, new)
    return text


def clean_environment():
    keep = {key: value for key, value in os.environ.items() if key == "LJMD_SIMD" or not key.startswith(("LC_", "LJMD"))}
    return {**keep, "LANG": "C", "TERM": "xterm"}


TIMES = ("began", "ended", "seconds_in_time_loop", "seconds_per_phase", "resumed_at_steps", "seconds")


def without_times(value):
    """JSON without what tells when and how fast a run was, and in how many parts."""
    if isinstance(value, dict):
        return {key: without_times(inner) for key, inner in value.items() if key not in TIMES}
    return [without_times(inner) for inner in value] if isinstance(value, list) else value


def run_outputs(directory):
    """Every file of a run but its checkpoints; of JSON what does not tell of time, of results.txt, which tells the same
    as results.json and a rate, nothing."""
    files = {name: data for name, data in snapshot(directory).items()
             if not name.startswith("checkpoint.") and name != "results.txt"}
    return {name: without_times(json.loads(data)) if name.endswith(".json") else data for name, data in files.items()}


def check_same_run(found, expected):
    """Two directories hold the same run, byte for byte, times excepted."""
    ours, theirs = run_outputs(found), run_outputs(expected)
    if ours.keys() != theirs.keys():
        raise Failure(f"files: {', '.join(sorted(ours))}; expected: {', '.join(sorted(theirs))}")
    for name, data in theirs.items():
        if ours[name] != data:
            raise Failure(f"{name} differs from that of the run to which nothing happened")


def snapshot(directory):
    """Every file's bytes, so that two looks at a directory can be compared."""
    return {str(p.relative_to(directory)): p.read_bytes() for p in sorted(Path(directory).rglob("*")) if p.is_file()}


def on_a_terminal(t, *arguments, stdout=subprocess.PIPE, **variables):
    """Run ljmd with stderr on a pseudo-terminal. @return exit code, stdout unless it goes elsewhere, stderr"""
    ours, theirs = pty.openpty()
    with subprocess.Popen([t.ljmd, *arguments], cwd=t.dir, stdin=subprocess.DEVNULL, stdout=stdout, stderr=theirs,
                          env={**clean_environment(), **variables}) as program:
        os.close(theirs)
        seen = b""
        while select.select([ours], [], [], waiting.PATIENCE)[0]:
            try:
                data = os.read(ours, 65536)  # holds a page or less
            except OSError:  # Linux: the other end is closed
                break
            if not data:
                break
            seen += data
        else:
            program.kill()
            raise Failure("hangs on a terminal")
        out = program.stdout.read().decode() if program.stdout else ""
        code = program.wait()
    os.close(ours)
    return code, out, seen.decode()


@contextlib.contextmanager
def held(directory):
    """The directory is locked by this process, as by one that runs in it."""
    lock = os.open(directory, os.O_RDONLY)  # not inherited by the program under test
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        yield
    finally:
        os.close(lock)


def run_cases(name, cases, ljmd, golden_path, update):
    """@return number of passed cases, number of failed ones"""
    golden = GoldenFile(golden_path, update)
    names = [case.name for case in cases]
    assert len(set(names)) == len(names), f"{name}: two cases of one name"
    failed = 0
    skipped = 0
    for case in cases:
        with tempfile.TemporaryDirectory(prefix="ljmd-cli-") as directory, contextlib.ExitStack() as stack:
            stack.callback(keeper.make_writable, directory)
            try:
                case.test(Context(ljmd, directory, lambda text, key=case.name: golden.compare(key, text)))
            except Skip as reason:
                skipped += 1
                print(f"skipped {name}: {case.name}: {reason}")
            except Failure as failure:
                failed += 1
                print(f"FAILED {name}: {case.name}: {failure}")
            except (LookupError, OSError, TypeError, ValueError) as surprise:  # a file that is missing or holds something else
                failed += 1
                print(f"FAILED {name}: {case.name}: {type(surprise).__name__}: {surprise}")
    wrong = golden.finish()
    for complaint in wrong:
        print(f"FAILED {name}: {complaint}")
    return len(cases) - failed - skipped, failed + len(wrong)
