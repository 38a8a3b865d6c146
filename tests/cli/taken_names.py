"""Every output that has a name of its own, and what may stand at that name: docs/reliability.md has the same table.

Whatever is there, the command ends with one message, nothing that is no file of ours is replaced without --force, nothing is written
through a link, and no other file stays behind.
"""

import os
import resource
import shutil
import stat
import subprocess
from dataclasses import dataclass

from foreign_files import as_nobody
from harness import DECK, STARS, Case, Failure, Skip, replaced

WITH_FRAMES = replaced(DECK, ("thermo = { every = 5 }", 'thermo = { every = 5 }\ntrajectory = { format = "xyz", every = 10 }'))
CUT = ("--cutoff", "2.5", "--truncation", "cut", "--tail", "false")
ENGINE = "command:echo evaluated; echo '{\"potential_energy\": 0}' >{output}/point.json; : {input}"
SWEEP = ("deck.toml", "--grid", "system.density=0.8", "--jobs", "1", "--quiet", "--out", "x")
TABLE = ("verlet1967", "--rows", "0.5", "--quick", "--prepare", "--out", "x")
GAS = ("--temperature", "2", "--density", "0.5", "--atoms", "108", "--replicas", "2", "--quiet", "--out", "x")


@dataclass
class Output:
    command: tuple
    name: str  # of the file, from the working directory
    older: str = "refused"  # an older one of ours: "refused", or "replaced" without --force
    codes: tuple = (0,)  # with which the command may end well
    needs_run: bool = False  # `out`, the directory of a run
    can_force: bool = True  # --force replaces a foreign file; else it refuses that, too
    runs: bool = True  # short enough to be run to its end
    copies: bool = True  # a copy of the program alone can do it, without scripts and modules
    says: str = ""  # part of each refusal; the name by default

    def __str__(self):
        return f"{self.name} of {' '.join(self.command[:4])}"


OUTPUTS = [
    Output(("report", "out", "--out", "page.html"), "page.html", older="replaced", needs_run=True),
    Output(("report", "out"), "out/report.html", older="replaced", needs_run=True),
    Output(("report", "out", "out"), "report.html", older="replaced", needs_run=True),
    Output(("plot", "out", "thermo", "--out", "x.svg"), "x.svg", older="replaced", needs_run=True, copies=False),
    Output(("plot", "out", "thermo"), "out/thermo.png", older="replaced", needs_run=True, copies=False),
    Output(("init", "x.toml"), "x.toml"),
    Output(("evaluate", "out/final.xyz", *CUT, "--out", "x.xyz"), "x.xyz", needs_run=True),
    Output(("evaluate", "out/final.xyz", *CUT, "--out", "x.dump"), "x.dump", needs_run=True),
    Output(("analyze", "out", "rdf", "--out", "x"), "x/rdf.csv", needs_run=True),
    *(Output(("export", "out", "--to", target, "--out", "x"), f"x/{name}", needs_run=True, copies=target != "openmm")
      for target, name in (("lammps", "start.data"), ("lammps", "in.lammps"), ("extxyz", "start.xyz"), ("h5md", "start.h5md"),
                           ("openmm", "system.xml"), ("openmm", "state.xml"), ("openmm", "integrator.xml"))),
    *(Output(("compare", "stars.toml", "--with", "gsl", "--quiet", "--out", "x"), f"x/compare-gsl.{ending}") for ending in ("csv", "json")),
    *(Output(("compare", "deck.toml", "--parts", "point", "--with", ENGINE, "--quiet", "--out", "x"), f"x/{name}", codes=(5,))
      for name in ("judge.json", "exchange/engine.log", "exchange/problem/problem.json", "exchange/problem/start.xyz",
                   "exchange/problem/start.data")),
    *(Output(("compare", "deck.toml", "--with", "files:x", "--quiet"), f"x/{name}", runs=False) for name in ("start.xyz", "start.data")),
    *(Output(("run", "deck.toml", "--quiet", "--out", "x"), f"x/{name}", says="error: x", runs=name != "report.html")
      for name in ("run.json", "results.json", "thermo.csv", "trajectory.xyz", "final.xyz", "checkpoint.1", "report.html")),
    *(Output(("sweep", *SWEEP), f"x/{name}", older="resumed", can_force=False, says="error: x")
      for name in ("sweep.csv", "points/deck.toml")),
    *(Output(("run", "deck.toml", "--replicas", "2", "--quiet", "--out", "x"), f"x/{name}", older="resumed")
      for name in ("results.json", "results.txt")),
    *(Output(("reproduce", *TABLE), f"x/{name}", older="resumed", runs=name.startswith("rows/"))
      for name in ("rows.csv", "isotherms.csv", "rows.md", "results.json", "rows/rho0.5000-T1.360.toml")),
    *(Output(("reference", *GAS), f"x/{name}", runs=False) for name in ("results.json", "results.txt", "rdf.csv", "sk.csv")),
]


def prepare(t, output):
    t.deck(text=WITH_FRAMES)
    t.deck(text=STARS, name="stars.toml")
    if output.needs_run:
        t.run_well("run", "deck.toml", "--quiet", "--out", "out")
    (t.dir / output.name).parent.mkdir(parents=True, exist_ok=True)
    return t.dir / output.name


def tree(t):
    """What is there: of files the bytes, of links where they lead to; no directories, which a refused command may make."""
    found = {}
    for path in sorted(t.dir.rglob("*")):
        kind = path.lstat().st_mode
        if not stat.S_ISDIR(kind):
            found[str(path.relative_to(t.dir))] = os.readlink(path) if stat.S_ISLNK(kind) else path.read_bytes() if stat.S_ISREG(kind) else kind
    return found


def refused(t, output, *more, codes=(2,), words="", prints=False, **options):
    """One message with the path, and nothing has changed."""
    before = tree(t)
    result = t.run(*output.command, *more, **options)
    t.check(result.code in codes, f"exit code {result.code}, expected {codes}; stderr:\n{result.err}")
    t.check(prints or not result.out, f"stdout: {result.out}")
    t.equal(result.err.count("error: "), 1, f"errors in {result.err!r}")
    t.contains(result.err, words or output.says or output.name)
    t.equal(tree(t), before, "files")


def ended_well(t, output, *more):
    result = t.run(*output.command, *more)
    if "without OpenMM" in result.err:
        raise Skip("ljmd was built without OpenMM")
    t.check(result.code in output.codes, f"exit code {result.code}; stderr:\n{result.err}")
    t.equal([name for name in t.files() if ".ljmd-" in name], [], "files left over")


def foreign_files(output):
    def test(t):
        path = prepare(t, output)
        path.write_text("mine")
        refused(t, output)
        if not output.can_force:
            refused(t, output, "--force")
        elif output.runs:
            ended_well(t, output, "--force")
            t.check(not path.exists() or path.read_bytes() != b"mine", "--force replaces nothing")
    return test


def older_files(output):
    def test(t):
        path = prepare(t, output)
        ended_well(t, output)
        if output.older == "refused":
            refused(t, output, words="already")
        else:
            ended_well(t, output)
        t.check(path.stat().st_size > 4, "it is empty")
    return test


def links(output):
    def test(t):
        path = prepare(t, output)
        precious = t.dir / "precious"
        precious.write_text("mine")
        path.symlink_to(precious)
        refused(t, output)
        path.unlink()
        path.symlink_to("nowhere")
        refused(t, output)
        os.mkfifo(t.dir / "pipe")
        for target in (t.dir / "pipe", ".", "/proc/self/fd/1"):
            path.unlink()
            path.symlink_to(target)
            for more in ((), ("--force",)):
                refused(t, output, *more)
        path.unlink()
        path.symlink_to(precious)
        if output.can_force and output.runs:
            ended_well(t, output, "--force")
            t.equal(t.read("precious"), "mine", "what the link leads to")
            t.check(not path.is_symlink(), "the link is still there")
    return test


def things_that_are_no_files(output):
    def test(t):
        path = prepare(t, output)
        for make in (os.mkdir, os.mkfifo):
            make(path)
            if make is os.mkdir:  # an empty one is no obstacle in a folder of runs
                (path / "mine").write_text("mine")
            for more in ((), ("--force",)):
                refused(t, output, *more)
            shutil.rmtree(path) if make is os.mkdir else path.unlink()
    return test


def a_full_disk(output):
    """No file can grow; those of before stay."""
    def test(t):
        path = prepare(t, output)
        ended_well(t, output)
        for limit in (0, 100):
            refused(t, output, *(() if output.older == "replaced" else ("--force",)), codes=(4,), words="File too large", prints=True,
                    preexec_fn=lambda most=limit: resource.setrlimit(resource.RLIMIT_FSIZE, (most, most)))
        t.check(path.stat().st_size > 4, "it is empty")
    return test


def no_permission(output):
    """The folder may be read and not be written to."""
    def test(t):
        path = prepare(t, output)
        path.write_text("mine")
        path.parent.chmod(0o555)
        options = {}
        if os.geteuid() == 0:
            if not output.copies:
                raise Skip("others may not enter the folder of scripts and modules")
            t.dir.chmod(0o755)
            t.ljmd = shutil.copy(t.ljmd, t.dir / "ljmd")
            options = {"preexec_fn": as_nobody}
            try:
                t.run_well("info", **options)
            except (Failure, OSError, subprocess.SubprocessError) as reason:
                raise Skip(f"others may not enter the folder for temporary files: {reason}") from reason
        refused(t, output, **options)
        refused(t, output, "--force", codes=(2, 4), words="Permission denied" if output.can_force else "", **options)
    return test


def streams_of_this_process(t):
    """As /dev/stdout, which root could replace."""
    t.deck()
    t.run_well("run", "deck.toml", "--quiet", "--out", "out")
    (t.dir / "stdout").symlink_to("/proc/self/fd/1")
    for more in ((), ("--force",)):
        result = t.expect(2, t.run("report", "out", "--out", "stdout", *more))
        t.contains(result.err, "error: stdout is in the way: ")
        t.equal(result.out, "", "stdout")
    t.check((t.dir / "stdout").is_symlink(), "the link was replaced")


def the_answer_of_an_engine_is_ours(t):
    """A folder that is removed before an engine runs is known by the problem beside it."""
    t.deck()
    (t.dir / "x/exchange/answer").mkdir(parents=True)
    (t.dir / "x/exchange/answer/thesis.txt").write_text("mine")
    command = ("compare", "deck.toml", "--parts", "point", "--with", ENGINE, "--quiet", "--out", "x")
    for more in ((), ("--force",)):
        t.contains(t.expect(2, t.run(*command, *more)).err, "error: x/exchange/answer is in the way: ")
    t.equal(t.read("x/exchange/answer/thesis.txt"), "mine", "a foreign file")
    (t.dir / "elsewhere").mkdir()
    shutil.rmtree(t.dir / "x/exchange")
    (t.dir / "x/exchange").symlink_to(t.dir / "elsewhere")
    t.contains(t.expect(2, t.run(*command, "--force")).err, "error: x/exchange is in the way: ")
    t.equal(t.files("elsewhere"), [], "files behind the link")


def a_report_that_a_deck_asks_for(t):
    """The results are there, and a warning says why the page is not."""
    t.deck(("thermo = { every = 5 }", "thermo = { every = 5 }\nreport = true"))
    t.expect(75, t.run("run", "deck.toml", "--out", "out", "--quiet", "--walltime", "0.000001s"))
    (t.dir / "out/report.html").write_text("mine")
    result = t.run_well("resume", "out", "--quiet")
    t.contains(result.err, "warning: there is no report: out/report.html is there already, and was not written by ljmd")
    t.equal(t.read("out/report.html"), "mine", "a foreign page")


def needs_pictures(output, test):
    """Pictures need a Python with matplotlib."""
    def tried(t):
        if output.command[0] == "plot" and "none was found" in t.run("plot", "none").err:
            raise Skip("no Python with numpy and matplotlib")
        test(t)
    return tried


def every_case():
    """Two minutes, for the long set."""
    tests = []
    for output in OUTPUTS:
        kinds = [foreign_files, links, things_that_are_no_files, no_permission]
        if output.runs:
            kinds += [older_files, a_full_disk] if output.older != "resumed" else [older_files]
        tests += [Case(f"{kind.__name__.replace('_', ' ')}: {output}", needs_pictures(output, kind(output))) for kind in kinds]
    return tests


def cases():
    alone = [Case(test.__name__.replace("_", " "), test)
             for test in (streams_of_this_process, the_answer_of_an_engine_is_ours, a_report_that_a_deck_asks_for)]
    return alone + every_case()[::5]  # each kind comes, with other outputs, since most have six or four
