"""ljmd reproduce verlet1967: rows that are run, kept, resumed and refused."""

import csv
import io
import json
import signal
import subprocess

from harness import Case, clean_environment, held, snapshot
import waiting

TWO_ROWS = ("reproduce", "verlet1967", "--quick", "--rows", "0.85:0.786,0.45:2.935", "--out", "out")
DENSE, THIN = "rho0.8500-T0.786", "rho0.4500-T2.935"
TABLES = ["out/results.json", "out/isotherms.csv", "out/rows.csv", "out/rows.md"]


def table(t):
    return list(csv.DictReader(io.StringIO(t.read("out/rows.csv"))))


def two_rows(t):
    environment = clean_environment()
    result = t.run_well(*TWO_ROWS, env=environment)
    t.equal(result.err.count("\n"), 2, "lines of progress")
    t.contains(result.err, "[2/2] rho ")
    t.contains(result.out, "chi-square")
    rows = table(t)
    t.equal([(row["rho"], row["T"]) for row in rows], [("0.85", "0.786"), ("0.45", "2.935")], "rows")
    for row in rows:
        for name, allowed in (("Z", 0.05), ("U", 0.03)):
            error = float(row[f"{name}_standard_error"])
            t.check(0.0 < error < allowed, f"standard error of {name}: {error}")
            apart = float(row[name]) + float(row[f"{name}_beyond_cutoff"]) - float(row[f"{name}_thol2016"])
            t.check(abs(apart) < allowed + 3.0 * error, f"{name} at {row['rho']}: {apart} from Thol's")
        t.equal(row["steps"], "1200", "steps")
        # What the run itself found, brought to Verlet's temperature.
        name = DENSE if row["rho"] == "0.85" else THIN
        found = t.json(f"out/rows/{name}/results.json")["observables"]
        t.check(abs(found["temperature"]["mean"] - float(row["T_measured"])) < 1e-12, "mean temperature")
        t.check(abs(found["potential_energy"]["mean"] - float(row["U"])) < 0.1, "mean energy")
    t.check(t.read("out/rows.md").count("\n| 0.") == 2, "rows of the Markdown table")
    again = snapshot(t.dir / "out")
    quiet = t.run_well(*TWO_ROWS, "--quiet", "--json", env=environment)
    t.equal(quiet.err, "", "stderr")
    t.equal(json.loads(quiet.out), t.json("out/results.json"), "JSON")
    t.equal(snapshot(t.dir / "out"), again, "a second time changes the files")


def rows_are_runs(t):
    """A row is an ordinary run of a deck that lies beside it."""
    t.run_well("reproduce", "verlet1967", "--quick", "--rows", "0.5", "--out", "out", "--jobs", "1")
    t.run_well("run", "out/rows/rho0.5000-T1.360.toml", "--out", "alone", "--quiet")
    t.equal(t.read("alone/thermo.csv"), t.read("out/rows/rho0.5000-T1.360/thermo.csv"), "thermo.csv")


def stopped_and_gone_on_with(number, code):
    def test(t):
        t.run_well(*TWO_ROWS)
        whole = {name: t.read(name) for name in TABLES}
        thermo = t.read(f"out/rows/{DENSE}/thermo.csv")
        process = subprocess.Popen([t.ljmd, *TWO_ROWS[:-1], "again"], cwd=t.dir, env=clean_environment(),
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        begun = t.dir / "again" / "rows" / DENSE / "thermo.csv"
        waiting.until(lambda: begun.exists() and begun.stat().st_size > 1000, "the first rows of the dense state", process)
        process.send_signal(number)
        _, talk = process.communicate(timeout=waiting.PATIENCE)
        t.equal(process.returncode, code, "exit code")
        t.contains(talk.decode(), "stopped; to go on, give the same command again\n")
        t.check(not (t.dir / "again" / "rows.csv").exists(), "rows.csv is there already")
        t.run_well(*TWO_ROWS[:-1], "again")
        for name, text in whole.items():
            t.equal(t.read(name.replace("out/", "again/")), text, name)
        t.equal(t.read(f"again/rows/{DENSE}/thermo.csv"), thermo, "thermo.csv")
        steps = t.json(f"again/rows/{DENSE}/run.json")["resumed_at_steps"]
        t.check(len(steps) == 1, f"resumed_at_steps {steps}")
    return test


def made_longer(t):
    """A row whose errors are too large is made longer, by as much as it was long."""
    t.run_well("reproduce", "verlet1967", "--rows", "0.5", "--out", "out", "--quiet")
    row = table(t)[0]
    t.check(float(row["Z_standard_error"]) <= 0.02 and float(row["U_standard_error"]) <= 0.004, f"errors: {row}")
    t.check(int(row["steps"]) % 10000 == 0, f"steps: {row['steps']}")
    record = t.json("out/rows/rho0.5000-T1.360/run.json")
    t.equal(record["steps_added"] + 10000, int(row["steps"]), "steps of the run")


def another_length(t):
    """What was run at another length is not taken for this, and not thrown away either."""
    t.run_well(*TWO_ROWS, "--quiet")
    before = snapshot(t.dir)
    full = [word for word in TWO_ROWS if word != "--quick"]
    result = t.expect(2, t.run(*full))
    t.golden(result.err)
    t.equal(snapshot(t.dir), before, "files")


def in_use(t):
    t.run_well(*TWO_ROWS, "--quiet")
    with held(t.dir / "out"):
        t.expect(9, t.run(*TWO_ROWS))


def a_row_that_fails(t):
    """The other rows are done all the same."""
    (t.dir / "out" / "rows").mkdir(parents=True)
    (t.dir / "out" / "rows" / DENSE).write_text("a file where a directory is wanted")
    result = t.expect(5, t.run(*TWO_ROWS))
    t.contains(result.err, f"warning: {DENSE}: exit code ")
    t.contains(result.err, "error: 1 of 2 rows failed; the same command tries them again\n")
    t.equal([row["rho"] for row in table(t)], ["0.45"], "rows")
    (t.dir / "out" / "rows" / DENSE).unlink()
    t.run_well(*TWO_ROWS)
    t.equal(len(table(t)), 2, "rows")


def refused(*arguments):
    def test(t):
        result = t.expect(2, t.run("reproduce", *arguments))
        t.equal(t.files(), [], "files")
        t.golden(result.err)
    return test


def cases():
    return [Case(test.__name__.replace("_", " "), test)
            for test in (two_rows, rows_are_runs, made_longer, another_length, in_use, a_row_that_fails)] + [
        Case("stopped by SIGINT", stopped_and_gone_on_with(signal.SIGINT, 130)),
        Case("stopped by SIGTERM", stopped_and_gone_on_with(signal.SIGTERM, 143)),
        Case("no table", refused()), Case("an unknown table", refused("rahman1964")),
        Case("an unknown row", refused("verlet1967", "--rows", "0.86")),
        Case("no jobs", refused("verlet1967", "--jobs", "0"))]
