"""`ljmd plot`: the program finds a Python and its scripts, and Python takes over. What is drawn: tests/analysis."""

import json
import os
import signal
import subprocess

from harness import STARS, Case, Skip, clean_environment
import waiting


ASKED = {}  # once: starting Python and its modules takes a second


def python_environment(t, **more):
    """As a person has it; the case is skipped where there is no Python that can draw."""
    chosen = {key: value for key, value in os.environ.items() if key == "LJMD_PYTHON"}
    if "answer" not in ASKED:
        ASKED["answer"] = t.run("plot", "nowhere", env={**clean_environment(), **chosen}).err
    if ASKED["answer"].startswith("error: pictures are drawn by Python"):
        raise Skip("no Python with numpy and matplotlib")
    return {**clean_environment(), **chosen, **more}


def pictures(t, *arguments, **options):
    return t.run_well("plot", *arguments, **options).out.splitlines()


def a_fluid(t):
    environment = python_environment(t)
    t.deck(("title = \"small\"", "title = '$x^{ <b> \u05d0\u05d1'"))
    t.run_well("run", "deck.toml", "--quiet", "--out", "out")
    t.equal(pictures(t, "out", env=environment), ["out/thermo.png", "out/atoms.png"], "pictures")
    t.equal(pictures(t, "out", "thermo", "--out", "a.svg", env=environment), ["a.svg"], "one picture")
    t.check(t.read("a.svg").startswith("<?xml"), "a.svg is no SVG")


def stopped_and_failed(t):
    """Runs are drawn as far as they got."""
    environment = python_environment(t)
    t.deck(("steps = 40", "steps = 1000000000"))
    process = subprocess.Popen([t.ljmd, "run", "deck.toml", "--quiet", "--out", "stopped"], cwd=t.dir, env=environment)
    rows = t.dir / "stopped/thermo.csv"
    waiting.until(lambda: rows.exists() and rows.stat().st_size > 2000, "some rows", process)
    process.terminate()
    t.equal(process.wait(waiting.PATIENCE), 128 + signal.SIGTERM, "exit code")
    t.equal(pictures(t, "stopped", env=environment), ["stopped/thermo.png"], "pictures of a stopped run")
    t.deck(("time_step = 0.004\nsteps = 40", "time_step = 0.2\nsteps = 40"))
    t.expect(5, t.run("run", "deck.toml", "--quiet", "--force", "--out", "failed"))
    t.equal(pictures(t, "failed", env=environment), ["failed/thermo.png", "failed/atoms.png"], "pictures of a failed run")


def running(t):
    environment = python_environment(t)
    t.deck(("steps = 40", "steps = 40000000"))
    with subprocess.Popen([t.ljmd, "run", "deck.toml", "--out", "out", "--quiet"], cwd=t.dir, stderr=subprocess.DEVNULL) as run:
        try:
            thermo = t.dir / "out/thermo.csv"
            while run.poll() is None and not (thermo.exists() and thermo.read_text().count("\n") > 5):
                pass
            t.equal(pictures(t, "out", env=environment), ["out/thermo.png"], "pictures of a run that goes on")
            t.equal(run.poll(), None, "the run")
        finally:
            run.send_signal(signal.SIGINT)
            run.wait()


def few_bodies_and_sweeps(t):
    environment = python_environment(t)
    t.deck(("[output]", "[output]\ntrajectory = { every = 5 }"), text=STARS)
    t.run_well("sweep", "deck.toml", "--grid", "stage.orbits.time_step=0.01|0.02", "--quiet", "--out", "sweep")
    t.equal(pictures(t, "sweep", env=environment), ["sweep/total_energy.png"], "of a sweep")
    point = next((t.dir / "sweep/points").glob("time_step=0.01"))
    t.equal(pictures(t, point, "orbit", "--out", "o.pdf", env=environment), ["o.pdf"], "of a point")


def the_equation_of_state(t):
    """The curve beside the points comes from this program, wherever it lies."""
    environment = python_environment(t, PATH="/usr/bin:/bin")
    t.deck(("density = 0.8442", "density = 0.5"), ("temperature = 1.0", "temperature = 2.0"))
    t.run_well("sweep", "deck.toml", "--grid", "system.density=0.3|0.5", "--quiet", "--out", "sweep")
    t.equal(t.json("sweep/points/density=0.3/results.json")["equation_of_state"], "thol2016", "equation of state")
    t.run_well("plot", "sweep", "pressure", "--out", "with.svg", env=environment)
    for point in ("0.3", "0.5"):
        path = t.dir / f"sweep/points/density={point}/results.json"
        path.write_text(json.dumps({**json.loads(path.read_text()), "equation_of_state": None}))
    t.run_well("plot", "sweep", "pressure", "--out", "without.svg", env=environment)
    t.check(len(t.read("with.svg")) > len(t.read("without.svg")), "no curve")


def what_is_wrong(t):
    """Exit codes are those of every command."""
    environment = python_environment(t)
    t.expect(2, t.run("plot"))
    t.expect(2, t.run("plot", "nowhere", env=environment))
    (t.dir / "empty").mkdir()
    t.golden(t.expect(3, t.run("plot", "empty", env=environment)).err)
    t.deck()
    t.run_well("run", "deck.toml", "--quiet", "--out", "out")
    t.contains(t.expect(2, t.run("plot", "out", "thermos", env=environment)).err, "did you mean 'thermo'?")
    t.contains(t.expect(2, t.run("plot", "out", "--out", "x.gif", env=environment)).err, "must end in .png, .pdf, .svg")
    (t.dir / "file").write_text("")
    t.contains(t.expect(4, t.run("plot", "out", "--out", "file/x.png", env=environment)).err, "cannot be written")


def no_python(t):
    """A Python that lacks the modules is no Python; a folder of their name in the working directory is not them."""
    for name in ("numpy", "matplotlib"):
        (t.dir / name).mkdir()
    bare = t.dir / "bare"
    bare.write_text("#!/bin/sh\nexit 1\n")
    bare.chmod(0o755)
    result = t.expect(2, t.run("plot", "nowhere", env={**clean_environment(), "LJMD_PYTHON": str(bare)}))
    t.contains(result.err, f"LJMD_PYTHON is '{bare}', which is no Python 3.9 with numpy and matplotlib")
    t.equal(result.out, "", "stdout")


def opened_for(process, pipe):
    """A pipe, open for writing once the process reads it. (An ordinary open would wait for ever if it never does.)"""
    def opened():
        try:
            return os.open(pipe, os.O_WRONLY | os.O_NONBLOCK)
        except OSError:  # nobody reads it yet
            return None
    return waiting.until(opened, f"{pipe.name} is read", process)


def interrupted(t):
    """Ctrl-C reaches Python, which is the process then: nothing is left over, and nothing is said."""
    environment = python_environment(t)
    t.deck()
    t.run_well("run", "deck.toml", "--quiet", "--out", "out")
    os.mkfifo(t.dir / "pipe")
    (t.dir / "site").mkdir()
    (t.dir / "site/sitecustomize.py").write_text(  # reading a table waits
        "import pathlib\nread = pathlib.Path.read_text\n\n\ndef waiting(path, **how):\n"
        f"    if path.suffix == '.csv':\n        open({str(t.dir / 'pipe')!r}).read()\n    return read(path, **how)\n\n\n"
        "pathlib.Path.read_text = waiting\n")
    environment["PYTHONPATH"] = str(t.dir / "site")
    with subprocess.Popen([t.ljmd, "plot", "out"], cwd=t.dir, env=environment, stderr=subprocess.PIPE) as process:
        with os.fdopen(opened_for(process, t.dir / "pipe"), "wb"):
            process.send_signal(signal.SIGINT)
        t.equal(process.wait(waiting.PATIENCE), -signal.SIGINT, "the end by SIGINT")
        t.equal(process.stderr.read(), b"", "stderr")
    t.equal([name for name in t.files("out") if name.endswith(".png")], [], "pictures")


def cases():
    return [Case(test.__name__.replace("_", " "), test)
            for test in (a_fluid, stopped_and_failed, running, few_bodies_and_sweeps, the_equation_of_state, what_is_wrong,
                         no_python, interrupted)]
