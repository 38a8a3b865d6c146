"""ljmd report: one page for every kind of directory, also for what is hostile, damaged, stopped or old."""

import base64
import json
import os
import re
import signal
import struct
import subprocess

from harness import ARGON, DECK, STARS, Case, clean_environment, held, snapshot
import waiting

HOSTILE = "</script><script>alert('&\\\"')</script><!-- \\u202e\\u2028"
FRAMES = ("thermo = { every = 5 }", 'thermo = { every = 5 }\ntrajectory = { format = "xyz", every = 10, velocities = true }')


def report(t, *directories):
    """The data of a page, which must be those that stand in the page."""
    printed = json.loads(t.run_well("report", *directories, "--json").out)
    page = t.run_well("report", *directories, "--out", "page.html")
    t.equal(page.out, "page.html\n", "what is printed")
    data = re.search(r'<script type="application/json" id="ljmd-data">(.*?)</script>', t.read("page.html"), re.DOTALL)
    t.equal(json.loads(data[1]), printed, "data in the page")
    return printed


def run(t, *replacements, text=DECK):
    t.deck(*replacements, text=text)
    t.run_well("run", "deck.toml", "--out", "out", "--quiet")


def numbers_are_the_results(t):
    """Quantities and their SI values are those of results.json, and nothing is asked for from anywhere."""
    run(t, FRAMES, ("[potential]", ARGON + "[potential]"))
    page = report(t, "out")
    t.equal(page["kind"], "run", "kind")
    t.equal(page["state"], "finished", "state")
    observables = t.json("out/results.json")["observables"]
    shown = {quantity["name"]: quantity for quantity in page["quantities"]}
    for name in ("temperature", "potential_energy", "kinetic_energy", "total_energy", "pressure"):
        t.equal(shown[name]["value"], observables[name]["mean"], name)
        t.equal(shown[name]["error"], observables[name]["standard_error"], f"error of {name}")
        t.equal(shown[name]["si_value"], observables[name]["si"]["mean"], f"{name} in SI")
    subjects = [verdict["subject"] for verdict in page["verdict"]]
    for subject in ("equilibrium", "energy", "error bars", "temperature", "equation of state"):
        t.check(subject in subjects, f"no verdict on {subject}")
    atoms = page["atoms"]
    positions = struct.unpack(f"<{3 * 108 * 7}H", base64.b64decode(atoms["positions"]))
    t.equal((atoms["atoms"], atoms["shown_frames"]), (108, 7), "atoms and frames")
    first = [float(word) for word in t.read("out/trajectory.xyz").splitlines()[2].split()[1:4]]
    t.equal([round(place / 65536 - x / edge % 1, 4) % 1 for place, x, edge in zip(positions, first, atoms["box"][0])],
            [0, 0, 0], "first atom")
    # Nothing but data and its own parts: no element that loads something.
    t.equal(re.findall(r"<(?:link|img|iframe|object|script[^>]*\bsrc)\b", t.read("page.html").split("<script>")[0]), [], "loads")


def titles_are_text(t):
    """No title ends the data, and it comes back as it was."""
    run(t, ('title = "small"', f'title = "{HOSTILE}"'))
    page = report(t, "out")
    t.equal(page["title"], "</script><script>alert('&\"')</script><!-- \u202e\u2028", "title")
    t.equal(t.read("page.html").count("<script"), 2, "script elements")


def places(t):
    """The page goes into the directory, or where it is told; several go into the working directory."""
    run(t)
    t.equal(t.run_well("report", "out").out, "out/report.html\n", "place")
    t.equal(t.run_well("report", "out", "out").out, "report.html\n", "place of several")
    t.run_well("run", "deck.toml", "--out", "out", "--quiet", "--force")
    t.check("report.html" not in t.files("out"), "a run that is replaced leaves its page")
    t.expect(4, t.run("report", "out", "--out", "nowhere/page.html"))
    before = snapshot(t.dir)
    t.run_well("report", "out", "--json")
    t.equal(snapshot(t.dir), before, "files after --json")


def decks_ask_for_it(t):
    """With report = true a run ends with its page, also one that was stopped and resumed."""
    run(t, ("[output]", "[output]\nreport = true"))
    t.check("report.html" in t.files("out"), "no page")
    t.contains(t.run_well("run", "deck.toml", "--out", "again", "--quiet").err, "report: again/report.html\n")
    t.deck(("[output]", "[output]\nreport = true"))
    t.expect(75, t.run("run", "deck.toml", "--out", "stopped", "--walltime", "1e-9s", "--quiet"))
    t.check("report.html" not in t.files("stopped"), "a page of a run that has not ended")
    t.equal(report(t, "stopped")["state"], "stopped", "state")


def few_bodies(t):
    run(t, ("thermo = { every = 10 }", "thermo = { every = 10 }\ntrajectory = { every = 5 }"), text=STARS)
    page = report(t, "out")
    t.equal(page["kind"], "few-body", "kind")
    tracks = page["tracks"]
    positions = struct.unpack(f"<{len(tracks['times']) * 2 * 3}f", base64.b64decode(tracks["positions"]))
    rows = t.columns("out/trajectory.csv")
    t.equal(positions[:6], (-1.0, 0.0, 0.0, 2.0, 0.0, 0.0), "start")
    t.check(abs(positions[-6] - rows["x1"][-1]) < 1e-6, "end")
    t.equal(len(tracks["energy_error"]), len(rows["time"]), "errors of the energy")
    record = t.json("out/run.json")
    for kind in ("fluid", "another"):
        (t.dir / "out/run.json").write_text(json.dumps({**record, "kind": kind}), encoding="utf-8")
        page = report(t, "out")
        t.equal(page["state"], "damaged", f"state where the kind is '{kind}'")
        t.equal(page["warnings"][0], f"out/run.json: 'kind' is '{kind}', but its deck is one of kind 'few-body'", "warning")


def studies(t):
    """A sweep has the numbers of its points, and links to those that have a page."""
    t.deck()
    t.run_well("sweep", "deck.toml", "--grid", "system.density=0.7|0.8442", "--out", "out", "--quiet")
    t.run_well("report", "out/points/density=0.7")
    page = report(t, "out")
    t.equal((page["kind"], page["state"]), ("sweep", "finished"), "kind and state")
    t.equal([point.get("href") for point in page["points"]], ["points/density=0.7/report.html", None], "links")
    table = next(table for table in page["tables"] if table["name"] == "points")
    pressures = table["values"][[column["name"] for column in table["columns"]].index("pressure")]
    for pressure, density in zip(pressures, ("0.7", "0.8442")):
        mean = t.json(f"out/points/density={density}/results.json")["observables"]["pressure"]["mean"]
        t.check(abs(pressure - mean) <= 1e-8 * abs(mean), f"pressure at {density}")


def comparisons(t):
    t.deck(text=STARS)
    t.run_well("compare", "deck.toml", "--with", "gsl", "--out", "out", "--quiet")
    page = report(t, "out")
    t.equal(page["kind"], "comparison", "kind")
    t.equal(page["verdict"][0]["level"], "good", "verdict")
    t.equal([chart["id"] for chart in page["charts"]], ["checks", "errors"], "charts")


def sets(t):
    run(t)
    t.run_well("run", "deck.toml", "--out", "warmer", "--quiet", "--set", "system.temperature=1.5")
    page = report(t, "out", "warmer")
    t.equal([member["label"] for member in page["members"]], ["out", "warmer"], "labels")
    t.equal(page["members"][1]["payload"], json.loads(t.run_well("report", "warmer", "--json").out), "a member")


def what_is_there(t):
    """A running, a damaged and an old directory have a page; what is no directory of ljmd has one message."""
    run(t, FRAMES)
    with held(t.dir / "out"):
        t.equal(report(t, "out")["state"], "finished", "state of a finished run that is being looked at")
    record = t.json("out/run.json")
    (t.dir / "out/run.json").write_text(json.dumps({**record, "finished": False, "ended": None}), encoding="utf-8")
    with held(t.dir / "out"):
        t.equal(report(t, "out")["state"], "running", "state")
    t.equal(report(t, "out")["state"], "stopped", "state")
    old = {key: value for key, value in record.items() if key not in ("given", "precision", "seconds_per_phase")}
    (t.dir / "out/run.json").write_text(json.dumps(old), encoding="utf-8")
    t.equal(report(t, "out")["state"], "finished", "state of a run of an older version")
    for name in ("thermo.csv", "trajectory.xyz", "results.json"):
        path = t.dir / "out" / name
        path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])
    page = report(t, "out")
    t.equal(page["state"], "damaged", "state")
    t.check(any("results.json" in warning for warning in page["warnings"]), "the damaged file is not named")
    (t.dir / "out/run.json").write_text('{"program": "ljmd"', encoding="utf-8")
    for directory in ("out", "deck.toml", "nowhere", "."):
        result = t.expect(3, t.run("report", directory))
        t.equal(result.err.count("error:"), 1, f"messages about {directory}")
    t.expect(2, t.run("report"))


def sizes(t):
    """A page of 864 atoms with many frames stays below 2 MB."""
    t.deck(("cells = 3", "cells = 6"), ("steps = 40", "steps = 400"), ("thermo = { every = 5 }",
           'thermo = { every = 1 }\ntrajectory = { format = "h5md", every = 2, velocities = true }'))
    t.run_well("run", "deck.toml", "--out", "out", "--quiet")
    page = report(t, "out")
    t.check((t.dir / "page.html").stat().st_size < 2_000_000, "the page is too large")
    t.equal(page["atoms"]["frames"], 211, "frames of the trajectory")
    t.contains(page["atoms"]["words"], "of 211 frames are shown")


def opened(t):
    """An opener may be the browser itself: it is not waited for, and lives on."""
    run(t)
    (t.dir / "bin").mkdir()
    os.mkfifo(t.dir / "go")
    (t.dir / "bin/xdg-open").write_text(f"#!/bin/sh\ncd '{t.dir}'\nread word < go\necho \"$1\" > opened.part\n"
                                        "mv opened.part opened\n", encoding="utf-8")
    (t.dir / "bin/xdg-open").chmod(0o755)
    environment = {**clean_environment(), "DISPLAY": ":7", "PATH": f"{t.dir}/bin:{os.environ['PATH']}"}
    t.expect(0, t.run("report", "out", "--open", env=environment))
    with open(t.dir / "go", "r+b", buffering=0) as go:  # for both ends, so that it waits for no reader
        go.write(b"go\n")
        waiting.until((t.dir / "opened").exists, "the opener, which lives on, goes on")
    t.equal(t.read("opened"), f"{t.dir}/out/report.html\n", "what is opened")


def data_of(path):
    """The data that stand in a page."""
    return json.loads(re.search(r'id="ljmd-data">(.*?)</script>', path.read_text(encoding="utf-8"), re.DOTALL)[1])


def followed(t):
    """The page of a run that goes on is written anew and reads itself anew; when the run has stopped it no longer does."""
    t.deck(("steps = 40", "steps = 1000000000"))
    page = t.dir / "out/report.html"
    with subprocess.Popen([t.ljmd, "run", "deck.toml", "--quiet", "--out", "out"], cwd=t.dir, stderr=subprocess.DEVNULL) as going:
        try:
            rows = t.dir / "out/thermo.csv"
            waiting.until(lambda: rows.exists() and rows.stat().st_size > 2000, "some rows", going)
            with subprocess.Popen([t.ljmd, "report", "out", "--follow", "--every", "0.05"], cwd=t.dir, stdout=subprocess.PIPE, text=True) as follower:
                waiting.until(page.exists, "the first page", follower)
                first = data_of(page)
                t.equal((first["state"], first["reload"]), ("running", 0.05), "the first page")
                waiting.until(lambda: data_of(page)["tables"] != first["tables"], "a page with more rows", follower)
                t.equal(follower.poll(), None, "who follows goes on")
                going.terminate()
                t.equal(going.wait(waiting.PATIENCE), 128 + signal.SIGTERM, "the run")
                t.equal((follower.wait(waiting.PATIENCE), follower.stdout.read()), (0, "out/report.html\n"), "who follows")
        finally:
            going.kill()
    last = data_of(page)
    t.equal((last["state"], last.get("reload")), ("stopped", None), "the last page")
    t.equal(t.run_well("report", "out", "--follow").out, "out/report.html\n", "of a run that does not go on")
    t.expect(2, t.run("report", "out", "out", "--follow"))
    t.expect(2, t.run("report", "out", "--every", "3"))
    (t.dir / "mine.html").write_text("mine")
    t.expect(2, t.run("report", "out", "--follow", "--out", "mine.html"))
    t.equal(t.read("mine.html"), "mine", "a file of the user")


def cases():
    return [Case("numbers are the results", numbers_are_the_results), Case("titles are text", titles_are_text),
            Case("places", places), Case("decks ask for it", decks_ask_for_it), Case("few bodies", few_bodies),
            Case("studies", studies), Case("comparisons", comparisons), Case("sets", sets),
            Case("what is there", what_is_there), Case("sizes", sizes), Case("opened", opened),
            Case("followed", followed)]
