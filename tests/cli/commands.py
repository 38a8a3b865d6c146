"""The command line itself: help, version, info, check, and what is no command."""

import json
import os
import re
import subprocess
from pathlib import Path

from harness import ARGON, DECK, STARS, Case, Skip, clean_environment, compare_refused

INPUTS = Path(__file__).resolve().parents[2] / "inputs"


def no_arguments(t):
    result = t.expect(2, t.run())
    t.equal(result.out, "", "stdout")
    for word in ("Usage: ljmd", "run", "check", "compare", "info"):
        t.contains(result.err, word)


def help_goes_to_stdout(t):
    for arguments in (["--help"], ["run", "--help"], ["check", "-h"], ["compare", "--help"]):
        result = t.run_well(*arguments)
        t.contains(result.out, "Usage: ljmd")
        t.equal(result.err, "", "stderr")


def version(t):
    result = t.run_well("--version")
    t.check(re.fullmatch(r"ljmd \d+\.\d+\.\d+\n", result.out), f"--version prints {result.out!r}")


def bad_usage(*arguments):
    def test(t):
        t.deck()
        result = t.expect(2, t.run(*arguments))
        t.equal(result.out, "", "stdout")
        t.equal(t.files(), ["deck.toml"], "files")
        t.golden(result.err)
    return test


def info(t):
    result = t.run_well("info")
    t.equal(result.err, "", "stderr")
    for word in ("ljmd ", "compiler", "flags", "simd", "lennard-jones", "morse", "force-shifted", "verlet-list",
                 "velocity-verlet", "rescale", "rdf", "openmm", "h5md", "xyz", "newtonian-gravity", "orbit"):
        t.contains(result.out, word)


def bench(t):
    t.deck()
    found = json.loads(t.run_well("bench", "deck.toml", "--json", "--threads", "2", "--precision", "mixed").out)
    t.equal(t.files(), ["deck.toml"], "files")
    t.equal((found["threads"], found["precision"]), (2, "mixed"), "threads and precision")
    t.check(found["atom_steps_per_second"] > 0.0, f"rate: {found['atom_steps_per_second']}")
    spent = sum(found["seconds_per_phase"].values())
    t.check(abs(spent - found["seconds"]) < 1e-9, f"phases take {spent} of {found['seconds']} s")


def threads_and_simd_change_no_result(t):
    """Threads change no bit; the lowest SIMD level gives the same physics."""
    t.deck()
    levels = json.loads(t.run_well("info", "--json").out)["simd_levels"]
    for name, options in (("one", []), ("two", ["--threads", "2"]), ("low", ["--simd", levels[0]])):
        t.run_well("run", "deck.toml", "--quiet", "--out", name, *options)
    t.check(t.read("one/thermo.csv") == t.read("two/thermo.csv"), "thermo.csv of two threads is another")
    record = json.loads(t.read("low/run.json"))
    t.equal((record["simd"], record["precision"]), (levels[0], "double"), "what run.json says of the kernels")
    last = [float(t.read(f"{name}/thermo.csv").splitlines()[-1].split(",")[5]) for name in ("one", "low")]
    t.check(abs(last[0] - last[1]) < 1e-9 * abs(last[0]), f"total energies {last}")


def unknown_simd_level(t):
    result = t.expect(2, t.run("bench", "--simd", "sse9"))
    t.check(result.err.startswith("error: unknown SIMD level 'sse9', usable here: portable"), f"stderr: {result.err}")


def info_json(t):
    result = t.run_well("info", "--json")
    t.equal(result.err, "", "stderr")
    found = json.loads(result.out)
    text = t.run_well("info").out
    t.contains(text, f"ljmd {found['version']} (commit {found['commit']})\n")
    for key in ("potentials", "truncations", "pair_searches", "forces", "thermostats", "barostats", "analyses",
                "few_body_analyses"):
        t.check(found[key] and all(isinstance(name, str) for name in found[key]), f"{key}: {found[key]}")
        t.contains(text, ", ".join(found[key]) + "\n")
    orders = {method["name"]: method["order"] for method in found["integrators"]}
    t.check(orders["velocity-verlet"] == 2 and orders["euler"] == 1, f"orders of integrators: {orders}")


def toml_keys(text):
    """Tables and keys of a deck that is written as ours are: one key a line, inline tables on one line."""
    keys = set(re.findall(r"^\[+([a-z_]+)\]+", text, flags=re.M))
    bare = re.sub(r'"[^"]*"', '""', re.sub(r"#.*", "", text))
    return keys | set(re.findall(r"([a-z_]+)\s*=", bare))


def info_keys(t):
    page = t.run_well("info", "--keys").out
    wanted = toml_keys((INPUTS / "verlet1967" / "argon-864.toml").read_text(encoding="utf-8"))
    t.check(len(wanted) > 25, f"the test finds only {sorted(wanted)} in the deck")
    missing = [key for key in sorted(wanted) if f"`{key}`" not in page and f"[{key}]" not in page]
    t.equal(missing, [], "keys of argon-864.toml that are not in the reference page")
    wanted = set().union(*(toml_keys(deck.read_text(encoding="utf-8")) for deck in (INPUTS / "fewbody").glob("*.toml")))
    missing = [key for key in sorted(wanted) if f"`{key}`" not in page and f"[{key}]" not in page]
    t.equal(missing, [], "keys of the few-body decks that are not in the reference page")
    t.check(page.startswith("# "), "the page is not Markdown")


def check_text(t):
    t.deck(text=DECK.replace("[system]", ARGON + "\n[system]"))
    result = t.run_well("check", "deck.toml")
    t.equal(result.err, "", "stderr")
    t.equal(t.files(), ["deck.toml"], "files after check")
    # what depends on the machine is left out
    t.golden(re.sub(r"(time +about ).*", r"\1...", result.out))


def check_json(t):
    t.deck()
    found = json.loads(t.run_well("check", "deck.toml", "--json", "--set", "stage.production.steps=100").out)
    t.equal(found["atoms"], 108, "atoms")
    t.equal(found["steps"], 120, "steps")
    t.equal(found["cutoff"], 2.5, "cutoff")
    edge = (108 / 0.8442) ** (1 / 3)
    t.check(all(abs(x - edge) < 1e-9 for x in found["box_edges"]), f"box edges {found['box_edges']}")
    t.check(abs(found["largest_cutoff"] - edge / 2) < 1e-9, "largest cutoff")
    for key in ("memory_bytes", "disk_bytes", "seconds"):
        t.check(found[key] > 0, f"{key} is {found[key]}")


def check_predicts(t):
    """The disk that a run takes is what check foretold, within a factor of 1.3."""
    t.deck(("thermo = { every = 5 }", 'thermo = { every = 1 }\ntrajectory = { every = 1, format = "xyz" }'))
    foretold = json.loads(t.run_well("check", "deck.toml", "--json").out)["disk_bytes"]
    t.run_well("run", "deck.toml", "--quiet")
    taken = sum((t.dir / "runs/deck" / name).stat().st_size for name in t.files("runs/deck"))
    t.check(1 / 1.3 < taken / foretold < 1.3, f"foretold {foretold:.0f} bytes, taken {taken}")


def peak_memory(t, *arguments):
    """Resident, at the highest."""
    with subprocess.Popen([t.ljmd, *arguments], cwd=t.dir, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                          env=clean_environment()) as program:
        _, status, usage = os.wait4(program.pid, 0)
        program.returncode = os.waitstatus_to_exitcode(status)
    t.equal(program.returncode, 0, "exit code of " + " ".join(arguments))
    return 1024 * usage.ru_maxrss


def check_predicts_memory(t):
    """For each pair search and precision, and for the analyses that keep most, within a factor of 1.3."""
    if peak_memory(t, "info") > 40e6:
        raise Skip("this ljmd is instrumented: it takes more memory")
    analyses = ("msd = { every = 1, origins = 10 }", "vacf = { every = 1 }", "structure_factor = { every = 4 }",
                "rdf = { every = 4 }", "chemical_potential = { every = 4, insertions = 100 }")
    cases = [(24, 'method = "cells"', ""), (24, "skin = 0.3", ""), (24, 'skin = 0.3\n[performance]\nprecision = "mixed"', ""),
             (12, 'method = "all-pairs"', "")] + [(20, "skin = 0.3", analysis) for analysis in analyses]
    for cells, search, analysis in cases:
        t.deck(("cells = 3", f"cells = {cells}"), ("skin = 0.3", search), ("steps = 20", "steps = 0"),
               ("steps = 40", f"steps = {40 if analysis else 1}"),
               ("thermo = { every = 5 }", "thermo = { every = 5 }\n" + (f"[analysis]\n{analysis}" if analysis else "")))
        foretold = json.loads(t.run_well("check", "deck.toml", "--json").out)["memory_bytes"]
        taken = peak_memory(t, "run", "deck.toml", "--quiet", "--force")
        t.check(1 / 1.3 < taken / foretold < 1.3,
                f"{cells} cells, {search}, {analysis}: foretold {foretold / 1e6:.1f} MB, taken {taken / 1e6:.1f}")


def check_tells_of_warnings(t):
    t.deck(("sample = true", "sample = true\ntemperature = 2.0"))
    t.golden(t.run_well("check", "deck.toml").err)
    t.equal(t.run_well("check", "deck.toml", "--quiet").err, "", "stderr with --quiet")


def a_large_cutoff_is_warned_of(t):
    t.deck(("cells = 3", "cells = 8"), ("cutoff = 2.5", "cutoff = 6.5"))
    t.golden(t.run_well("check", "deck.toml").err)


def forced_values_are_warned_of(t):
    t.deck(("time_step = 0.004\nsteps = 40", "time_step = 0.02\nsteps = 40"), ("temperature = 1.0", "temperature = 60.0"))
    t.expect(2, t.run("check", "deck.toml"))
    t.golden(t.run_well("check", "deck.toml", "--force").err)


def check_few_bodies(t):
    t.deck(text=STARS)
    result = t.run_well("check", "deck.toml")
    t.equal(result.err, "", "stderr")
    t.golden(result.out)
    found = json.loads(t.run_well("check", "deck.toml", "--json", "--set", "stage.orbits.steps=50").out)
    t.equal((found["bodies"], found["dimensions"], found["steps"]), (2, 2, 50), "bodies, dimensions, steps")
    t.equal(t.files(), ["deck.toml"], "files after check")


def compare_text(t):
    t.deck(text=STARS)
    result = t.run_well("compare", "deck.toml", "--with", "gsl", "--quiet")
    t.equal(result.err, "", "stderr")
    t.equal(t.files(), ["deck.toml"], "files after compare")
    lines = result.out.splitlines()
    t.equal(lines[0], "stars", "title")
    t.equal(lines[3].split()[:4], ["time", "position", "velocity", "energy"], "columns")
    last = next(line for line in reversed(lines) if line.split()[:1] == ["1"]).split()
    t.check(1e-8 < float(last[1]) < 1e-3, f"position error at the end: {last[1]}")
    t.check(float(last[5]) < 1e-10, f"error of the reference: {last[5]}")


def compare_files(t):
    t.deck(text=STARS)
    printed = t.run_well("compare", "deck.toml", "--with", "gsl", "--json", "--out", "some/where").out
    t.equal(t.files(), ["deck.toml", "some", "some/where", "some/where/compare-gsl.csv", "some/where/compare-gsl.json"],
            "files after compare")
    t.equal(t.read("some/where/compare-gsl.json"), printed, "compare-gsl.json")
    found = json.loads(printed)
    t.check(found["passed"] is True, f"checks: {found['checks']}")
    columns = t.columns("some/where/compare-gsl.csv")
    t.equal(columns["step"], [float(n) for n in range(101)], "steps")
    for name in ("position_error", "velocity_error", "energy_error", "angular_momentum_error", "reference_error"):
        t.equal(columns[name], [row[name] for row in found["rows"]], name)


def compare_halved(t):
    """Half the step, a quarter of the error: it is the integrator's."""
    t.deck(text=STARS)
    errors = []
    for step, steps in ((0.01, 200), (0.005, 400)):
        arguments = ["--set", f"stage.orbits.time_step={step}", "--set", f"stage.orbits.steps={steps}"]
        out = t.run_well("compare", "deck.toml", "--with", "gsl", "--json", "--quiet", *arguments).out
        errors.append(json.loads(out)["largest_position_error"])
    t.check(3.8 < errors[0] / errors[1] < 4.2, f"position errors {errors}")


def info_of_a_deck(t):
    t.deck()
    t.golden(t.expect(3, t.run("info", "deck.toml")).err)


def cases():
    result = [Case(test.__name__.replace("_", " "), test)
              for test in (no_arguments, help_goes_to_stdout, version, info, info_keys, check_text, check_json,
                           info_json, bench, threads_and_simd_change_no_result, unknown_simd_level, check_few_bodies, compare_text, compare_files, compare_halved,
                           check_predicts, check_predicts_memory, check_tells_of_warnings, a_large_cutoff_is_warned_of,
                           forced_values_are_warned_of)]
    for name, arguments in [
            ("unknown command", ["rnu", "deck.toml"]), ("unknown command without a likeness", ["simulate", "deck.toml"]),
            ("unknown option", ["run", "deck.toml", "--walltme", "2h"]), ("unknown option of ljmd", ["--verbose"]),
            ("run without a deck", ["run"]), ("no threads", ["run", "deck.toml", "--threads", "0"]), ("check without a deck", ["check"]),
            ("run with two decks", ["run", "deck.toml", "other.toml"]), ("--set without a value", ["run", "deck.toml", "--set"]),
            ("--out without a value", ["run", "deck.toml", "--out"]), ("check with --out", ["check", "deck.toml", "--out", "x"]),
            ("two commands", ["info", "check", "deck.toml"]),
            ("info with keys and JSON", ["info", "--keys", "--json"]), ("compare without a program", ["compare", "deck.toml"]),
            ("compare without a deck", ["compare", "--with", "gsl"])]:
        result.append(Case(name, bad_usage(*arguments)))
    result.append(Case("info of a deck", info_of_a_deck))
    back = STARS.replace("[output]", '[[stage]]\nname = "back"\ntime_step = 0.01\nsteps = 1\nreverse = true\n\n[output]')
    result += [Case("compare a fluid with gsl", compare_refused(DECK, "--with", "gsl")),
               Case("compare with an unknown program", compare_refused(STARS, "--with", "gromacs")),
               Case("compare a motion that turns round", compare_refused(back, "--with", "gsl")),
               Case("compare a deck with a mistake", compare_refused(STARS, "--with", "gsl", "--set", "body.1.mass=0"))]
    return result
