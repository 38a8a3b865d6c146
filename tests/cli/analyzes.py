"""ljmd analyze: where a run has come to equilibrium, and what it refuses."""

import json

from harness import Case


def finished_run(t):
    t.deck(("steps = 40", "steps = 200"))
    t.run_well("run", "deck.toml", "--out", "out", "--quiet", "--set", "output.thermo.every=2")


def a_run_that_has_ended(t):
    finished_run(t)
    before = {path: path.read_bytes() for path in (t.dir / "out").iterdir()}
    text = t.run_well("analyze", "out")
    t.equal(text.err, "", "stderr")
    found = json.loads(t.run_well("analyze", "out", "--json").out)
    t.equal(found["rows"], 100, "rows")
    t.contains(text.out, f"100 rows of thermo.csv, steps {found['first_step']} to {found['last_step']}")
    for name, observable in found["observables"].items():
        t.contains(text.out, name)
        t.check((observable["independent_samples"] or 0) <= 100, f"{name}: {observable}")
    results = t.json("out/results.json")["observables"]
    for name, observable in found["observables"].items():
        t.check(abs(observable["mean_of_all"] - results[name]["mean"]) < 1e-12, f"{name}: mean of all rows")
        error = results[name]["standard_error"]
        t.check(abs(observable["blocking_standard_error_of_all"] - error) < 1e-9 * error, f"{name}: its error")
    t.equal(found["observables"]["total_energy"]["equilibrium"], "conserved", "the total energy")
    for key in ("mean", "standard_error"):
        ours, theirs = found["heat_capacity_cv"][key], results["heat_capacity_cv"][key]
        t.check(ours == theirs or abs(ours - theirs) < 1e-9 * theirs, f"heat capacity, {key}: {ours}, the run has {theirs}")
    t.equal({path: path.read_bytes() for path in (t.dir / "out").iterdir()}, before, "the run directory")


def a_run_that_goes_on(t):
    """The last line of thermo.csv is half written."""
    finished_run(t)
    text = t.read("out/thermo.csv")
    (t.dir / "out/thermo.csv").write_text(text[:-30])
    t.contains(t.run_well("analyze", "out").out, "99 rows of thermo.csv")


def refused(code, *arguments):
    def test(t):
        result = t.expect(code, t.run("analyze", *arguments))
        t.equal(result.out, "", "stdout")
        t.golden(result.err)
    return test


def without_rows(t):
    finished_run(t)
    (t.dir / "out/thermo.csv").unlink()
    t.golden(t.expect(3, t.run("analyze", "out")).err)


def cases():
    return [Case(test.__name__.replace("_", " "), test)
            for test in (a_run_that_has_ended, a_run_that_goes_on, without_rows)] + [
        Case("no directory", refused(2)),
        Case("a directory that is not there", refused(3, "nowhere")),
        Case("two directories", refused(2, "one", "two"))]
