"""ljmd sweep: points that are run, kept, resumed, tried again and refused."""

import csv
import io
import json
import os
import signal
import subprocess
from pathlib import Path

from harness import DECK, STARS, Case, clean_environment, held, run_outputs, snapshot
import waiting

GRID = ("sweep", "deck.toml", "--grid", "system.temperature=1.2:2.0:2,system.density=0.7|0.8442", "--jobs", "2", "--out", "out")
POINTS = [("1.2", "0.7"), ("1.2", "0.8442"), ("2", "0.7"), ("2", "0.8442")]
# Of these points the first is done at once, the second takes its time and leaves checkpoints.
LONG = ("sweep", "deck.toml", "--grid", "stage.production.steps=40|20000", "--set", "output.checkpoint={ every = 500 }",
        "--jobs", "1", "--out")
SHORT_POINT, LONG_POINT = "points/steps=40", "points/steps=20000"


def rows(t, path="out/sweep.csv"):
    return list(csv.DictReader(io.StringIO(t.read(path))))


def outputs(directory):
    """What a run has left, but for where its deck lay."""
    files = run_outputs(directory)
    del files["run.json"]["deck_file"]
    return files


def times(directory):
    """When each file of a directory was written."""
    return {path.name: path.stat().st_mtime_ns for path in directory.iterdir()}


def name(point):
    return f"temperature={point[0]},density={point[1]}"


def a_grid_is_its_runs(t):
    """The points are what single runs are, number for number; a second time nothing is done."""
    t.deck()
    result = t.run_well(*GRID)
    t.equal(result.err.count("\n"), 4, "lines of progress")
    t.contains(result.err, "[4/4] temperature=")
    t.equal(result.out.splitlines()[0].split(), ["temperature", "density", "T", "U/N", "p", "Z"], "head of the table")
    t.contains(result.out, "\nfiles: out\nto draw them: ljmd plot out\n")
    found = rows(t)
    t.equal([(row["system.temperature"], row["system.density"]) for row in found], POINTS, "points")
    for row, point in zip(found, POINTS):
        t.run_well("run", "deck.toml", "--out", "alone", "--quiet", "--force", "--set", f"system.temperature={point[0]}",
                   "--set", f"system.density={point[1]}")
        observables = t.json("alone/results.json")["observables"]
        t.equal(len(row), 2 + 2 * len(observables) + 1, "columns, the last one for remarks")
        for observable, value in observables.items():
            for column, key in ((observable, "mean"), (f"{observable}_standard_error", "standard_error")):
                number = float(row[column]) if row[column] else None
                t.equal(number, value[key], f"{column} at {point}")
        t.check(outputs(t.dir / "alone") == outputs(t.dir / "out/points" / name(point)), f"files at {point}")
    before = snapshot(t.dir / "out")
    again = t.run_well(*GRID, "--quiet", "--json")
    t.equal(again.err, "", "stderr")
    t.equal(snapshot(t.dir / "out"), before, "a second time changes the files")
    points = json.loads(again.out)["points"]
    t.equal([point["values"] for point in points],
            [{"system.temperature": float(a), "system.density": float(b)} for a, b in POINTS], "values in JSON")
    t.equal(points[3]["observables"]["pressure"]["mean"], float(found[3]["pressure"]), "pressure in JSON")


def a_list_of_points(t):
    t.deck()
    (t.dir / "points.csv").write_text('system.temperature,"system.lattice"\r\n1.5,"{ type = ""fcc"", cells = 3 }"\r\n'
                                      '1.2,"{ type = ""simple-cubic"", cells = 5 }"\r\n')
    t.run_well("sweep", "deck.toml", "--list", "points.csv", "--quiet", "--set", "system.seed=3")
    found = rows(t, "runs/deck-sweep/sweep.csv")
    t.equal([row["system.temperature"] for row in found], ["1.5", "1.2"], "temperatures")
    records = [t.json(path.relative_to(t.dir)) for path in sorted(t.dir.glob("runs/deck-sweep/points/*/results.json"))]
    t.equal([record["system"]["atoms"] for record in records], [125, 108], "atoms")


def seeds_of_their_own(t):
    """With --seeds each point is the run of the deck with the next seed; without it a line under the table says that they have one."""
    t.deck(("seed = 7", "seed = 41"))
    grid = ("sweep", "deck.toml", "--quiet", "--grid", "system.temperature=1.5|1.2|1.7")
    t.contains(t.run_well(*grid, "--out", "alike").out, "All points have one seed")
    told = t.run_well(*grid, "--seeds", "--out", "own").out
    t.check("All points have one seed" not in told, "a line about seeds")
    found = rows(t, "own/sweep.csv")
    t.equal([row["system.seed"] for row in found], ["41", "42", "43"], "seeds")
    t.run_well("run", "deck.toml", "--out", "alone", "--quiet", "--set", "system.temperature=1.7", "--set", "system.seed=43")
    t.equal(outputs(t.dir / "own/points/temperature=1.7,seed=43"), outputs(t.dir / "alone"), "files of the last point")
    page = json.loads(t.run_well("report", "own", "--json").out)
    t.check(page["charts"] and all(not mark.get("group") for chart in page["charts"] for mark in chart["marks"]), "one line, not one a seed")
    again = t.run_well(*grid, "--seeds", "--out", "own").out
    t.equal(again, told, "the same sweep again")
    t.contains(t.expect(2, t.run("sweep", "deck.toml", "--seeds", "--grid", "system.seed=1|2")).err, "'system.seed' is varied")
    t.deck(text=STARS)
    t.contains(t.expect(2, t.run("sweep", "deck.toml", "--seeds", "--grid", "stage.orbits.time_step=0.01|0.005")).err, "few bodies have no seed")


def few_bodies(t):
    t.deck(text=STARS)
    grid = "body.1.position=[-1.0, 0.0]|[-1.5, 0.0],stage.orbits.time_step=0.01|0.005"
    result = t.run_well("sweep", "deck.toml", "--out", "out", "--grid", grid, "--set", "analysis.closest_approach={}")
    t.contains(result.out.splitlines()[0], "total energy")
    found = rows(t)
    t.equal([row["body.1.position"] for row in found], ["[-1.0, 0.0]"] * 2 + ["[-1.5, 0.0]"] * 2, "positions")
    t.check(all(row["total_energy"] and not row["total_energy_standard_error"] for row in found), f"energies: {found}")
    t.check(all(float(row["closest_approach_distance"]) > 0.0 for row in found), "closest approaches")


def children(process):
    """Processes that a process has started."""
    found = []
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = stat.read_text().rpartition(")")[2].split()
        except OSError:  # it has ended
            continue
        if int(fields[1]) == process.pid:
            found.append(int(stat.parent.name))
    return found


def begin_long(t, out):
    """The long sweep, when its first point is done and the second has begun to write checkpoints."""
    process = subprocess.Popen([t.ljmd, *LONG, out], cwd=t.dir, env=clean_environment(), stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE)
    record = t.dir / out / LONG_POINT / "checkpoint.2"
    waiting.until(record.exists, "the second checkpoint", process)
    return process


def check_resumed(t):
    for point in (SHORT_POINT, LONG_POINT):
        t.check(outputs(t.dir / "again" / point) == outputs(t.dir / "out" / point), f"files of {point}")
    t.equal(t.read("again/sweep.csv"), t.read("out/sweep.csv"), "sweep.csv")
    t.equal(t.json(f"again/{SHORT_POINT}/run.json")["resumed_at_steps"], [], "resumed_at_steps of the first")
    t.equal(len(t.json(f"again/{LONG_POINT}/run.json")["resumed_at_steps"]), 1, "resumed_at_steps of the second")


def killed_and_gone_on_with(t):
    """Points finished when all processes were killed are not touched; the others are resumed."""
    t.deck()
    t.run_well(*LONG, "out", "--quiet")
    process = begin_long(t, "again")
    victims = children(process)
    t.equal(len(victims), 1, "processes of the sweep")
    process.kill()
    for victim in victims:
        os.kill(victim, signal.SIGKILL)
    process.communicate()
    t.check(not (t.dir / "again" / LONG_POINT / "results.json").exists(), "killed too late")
    done = times(t.dir / "again" / SHORT_POINT)
    result = t.run_well(*LONG, "again")
    t.contains(result.err, "[1/2] steps=40: T ")
    t.check(times(t.dir / "again" / SHORT_POINT) == done, "files of a point that was done are written again")
    check_resumed(t)


def stopped_and_gone_on_with(number, code):
    def test(t):
        t.deck()
        t.run_well(*LONG, "out", "--quiet")
        process = begin_long(t, "again")
        process.send_signal(number)
        out, talk = process.communicate(timeout=waiting.PATIENCE)
        t.equal((process.returncode, out), (code, b""), "exit code and stdout")
        t.contains(talk.decode(), "stopped; to go on, give the same command again\n")
        t.check(not (t.dir / "again" / "sweep.csv").exists(), "sweep.csv is there already")
        t.run_well(*LONG, "again", "--quiet")
        check_resumed(t)
    return test


def ended_and_gone_on_with(*numbers):
    """A sweep that is ended without a chance to stop its points: they stop by themselves, and the same command goes on
    with them at once."""
    def test(t):
        t.deck()
        t.run_well(*LONG, "out", "--quiet")
        process = begin_long(t, "again")
        victims = children(process)
        t.equal(len(victims), 1, "processes of the sweep")
        for number in numbers:
            process.send_signal(number)
        process.communicate(timeout=waiting.PATIENCE)
        t.run_well(*LONG, "again", "--quiet")
        check_resumed(t)
    return test


def the_deck_may_change_meanwhile(t):
    """The sweep is resumed with the deck as it was; the changed deck is another sweep."""
    t.deck()
    process = begin_long(t, "out")
    t.deck(("seed = 7", "seed = 8"))
    process.send_signal(signal.SIGTERM)
    process.communicate(timeout=waiting.PATIENCE)
    t.expect(2, t.run(*LONG, "out"))
    t.deck()
    t.run_well(*LONG, "out", "--quiet")
    for point in (SHORT_POINT, LONG_POINT):
        t.contains(t.json(f"out/{point}/run.json")["deck"], "seed = 7")


def a_point_that_fails(t):
    """The other points are done all the same, and it is tried again."""
    t.deck()
    (t.dir / "out").mkdir()
    blown_up = ("sweep", "deck.toml", "--out", "out", "--grid", "stage.production.time_step=0.001|0.4|0.002", "--force")
    for _ in range(2):
        result = t.expect(5, t.run(*blown_up))
        t.contains(result.err, "warning: time_step=0.4: exit code 5: error: ")
        t.contains(result.err, "error: 1 of 3 points failed; the same command tries them again\n  time_step=0.4: exit code 5: ")
        t.check("failed" in result.out.splitlines()[2], result.out)
        found = rows(t)
        t.equal([bool(row["pressure"]) for row in found], [True, False, True], "points with a pressure")
    failure = [point["failure"] for point in json.loads(t.expect(5, t.run(*blown_up, "--json")).out)["points"]]
    t.equal([failure[0], failure[2]], [None, None], "failures in JSON")
    t.contains(failure[1], "time_step=0.4: exit code 5: ")


def a_point_that_is_helped(t):
    """What has failed for a reason outside of the deck is done when the reason is gone."""
    t.deck()
    t.run_well(*GRID, "--quiet")
    point = t.dir / "out/points" / name(POINTS[1])
    whole = t.read("out/sweep.csv")
    results = (point / "results.json").read_text()
    (point / "results.json").write_text("{")
    result = t.expect(5, t.run(*GRID))
    t.contains(result.err, f"warning: {name(POINTS[1])}: out/points/{name(POINTS[1])}/results.json is not the result of a run")
    (point / "results.json").write_text(results)
    t.run_well(*GRID, "--quiet")
    t.equal(t.read("out/sweep.csv"), whole, "sweep.csv")


def another_sweep(t):
    """Another sweep is refused and nothing is changed; with --force what both have in common is kept."""
    t.deck()
    t.run_well(*GRID, "--quiet")
    (t.dir / "out/mine.txt").write_text("mine")
    before = snapshot(t.dir)
    larger = [*GRID[:3], "system.temperature=1.2:2.8:3,system.density=0.7|0.8442", *GRID[4:]]
    result = t.expect(2, t.run(*larger))
    t.golden(result.err)
    t.expect(2, t.run(*GRID, "--set", "system.seed=3"))
    t.equal(snapshot(t.dir), before, "files")
    kept = times(t.dir / "out/points" / name(POINTS[2]))
    t.run_well(*larger, "--force", "--quiet")
    t.check(times(t.dir / "out/points" / name(POINTS[2])) == kept, "a point of both is written again")
    t.equal(len(rows(t)), 6, "points")
    t.run_well(*GRID[:3], "system.density=0.8", *GRID[4:], "--force", "--quiet")
    t.equal([path.name for path in sorted((t.dir / "out/points").iterdir())], ["deck.toml", "density=0.8", "density=0.8.log"],
            "what is left")
    t.equal(t.read("out/mine.txt"), "mine", "a file of others")


def not_a_sweep(t):
    t.deck()
    (t.dir / "out/points/kept").mkdir(parents=True)
    result = t.expect(2, t.run(*GRID, "--force"))
    t.golden(result.err)
    t.equal(t.files(), ["deck.toml", "out", "out/points", "out/points/kept"], "files")


def in_use(t):
    t.deck()
    (t.dir / "out").mkdir()
    with held(t.dir / "out"):
        t.expect(9, t.run(*GRID))


def warnings_are_said_once(t):
    t.deck()
    unlikely = ("sweep", "deck.toml", "--out", "out", "--grid", "potential.cutoff=2.5|6.5|7", "--set",
                "system.lattice.cells=5", "--set", "system.density=0.1")
    result = t.run_well(*unlikely)
    t.equal(result.err.count("warning: "), 1, "warnings")
    t.contains(result.err, "(cutoff=6.5; cutoff=7)")
    t.equal(t.run_well(*unlikely, "--quiet").err, "", "stderr with --quiet")


def refused(*arguments, points=None, code=2):
    """A case: the sweep is refused with a golden message, and nothing is written."""
    def test(t):
        t.deck(text=DECK)
        if points is not None:
            (t.dir / "points.csv").write_bytes(points)
        before = t.files()
        result = t.expect(code, t.run("sweep", "deck.toml", *arguments))
        t.equal((result.out, t.files()), ("", before), "stdout and files")
        t.golden(result.err)
    return test


def cases():
    grid = [("an unknown key", "system.densty=0.1:0.8:8,system.temperature=1:2:3"),
            ("values that the deck refuses", "system.density=-0.1:0.8:10,potential.truncation=cut|none"),
            ("densities for which the box is too small", "system.density=0.5:1.4:10"),
            ("an unknown stage", "stage.sample.steps=1|2"), ("steps that are no integers", "stage.melt.steps=1:2:3"),
            ("a range that is none", "system.density=0.1:0.9"), ("a range of one", "system.density=0.1:0.9:1"),
            ("a range from nan to inf", "system.density=nan:inf:3"), ("a huge count", "system.density=0:1:1000000000000000000000"),
            ("too many points", "system.density=0.1:0.8:200,system.temperature=1:2:200"),
            ("an empty grid", ""), ("no values", "system.density="), ("a key twice", "system.density=0.1|0.2,system.density=0.3"),
            ("a value twice", "system.density=0.1|0.2|0.1"), ("a key in a script of its own", "system.Dichte\u00e4=1|2")]
    lists = [("a list with a ragged row", b"system.density,system.temperature\n0.5,1\n0.6\n0.7,1,2\n0.5,1\n", 2),
             ("a list with values that the deck refuses", b"system.density,system.temperature\n0.5,1\n-0.5,hot\n", 2),
             ("an empty list", b"", 2), ("a list with a header alone", b"system.density\n", 2),
             ("a list that is not text", b"\xff\xfe\n\x00\n", 3), ("a list that is not there", None, 3)]
    return [Case(test.__name__.replace("_", " "), test)
            for test in (a_grid_is_its_runs, a_list_of_points, seeds_of_their_own, few_bodies, killed_and_gone_on_with,
                         the_deck_may_change_meanwhile, a_point_that_fails, a_point_that_is_helped, another_sweep, not_a_sweep,
                         in_use, warnings_are_said_once)] + [
        Case("stopped by SIGINT", stopped_and_gone_on_with(signal.SIGINT, 130)),
        Case("stopped by SIGTERM", stopped_and_gone_on_with(signal.SIGTERM, 143)),
        Case("stopped by SIGUSR1", stopped_and_gone_on_with(signal.SIGUSR1, 138)),
        Case("killed and given again at once", ended_and_gone_on_with(signal.SIGKILL)),
        Case("quit and given again at once", ended_and_gone_on_with(signal.SIGQUIT)),
        Case("interrupted twice and given again at once", ended_and_gone_on_with(signal.SIGINT, signal.SIGINT)),
        Case("no points", refused()), Case("points twice", refused("--grid", "system.density=1|2", "--list", "points.csv")),
        Case("a key that --set gives too", refused("--grid", "system.density=0.5|0.6", "--set", "system.density=0.7"))] + [
        Case(what, refused("--grid", text)) for what, text in grid] + [
        Case(what, refused("--list", "points.csv", points=text, code=code)) for what, text, code in lists]
