"""ljmd reference: values to a wanted error, what is refused, and what is resumed."""

import json
import signal

from harness import Case, snapshot
from resumes import end, start
import waiting

# A dense gas of 108 atoms, whose runs take a second.
GAS = ("--temperature", "2", "--density", "0.5", "--atoms", "108")
QUICK = (*GAS, "--replicas", "2", "--error", "energy=0.02")


def reference(t, *arguments, out="out", quiet=True):
    return t.run_well("reference", *arguments, "--out", out, *(["--quiet"] if quiet else []))


def found(t, *arguments, out="out"):
    return json.loads(reference(t, *arguments, "--json", out=out).out)


def values_reach_their_errors(t):
    """Energy and pressure are those of the equation of state, within errors that are as small as was asked for."""
    data = found(t, *GAS, "--error", "energy=0.01,pressure=0.012")
    t.equal((data["phase"], data["density"], data["temperature"], data["warnings"]), ("supercritical fluid", 0.5, 2, []), "state")
    for name, error in (("potential_energy", 0.01), ("pressure", 0.012)):
        value = data[name]
        t.check(0 < value["statistical_error"] <= error, f"error of {name}: {value}")
        t.check(data["errors"][name]["reached"], f"{name} is not reached")
        fits = value["equations_of_state"]
        uncertain = (value["total_error"] ** 2 + (fits["thol2016"] - fits["kolafa-nezbeda1994"]) ** 2) ** 0.5
        t.check(abs(value["mean"] - value["equation_of_state"]) < 5 * uncertain, f"{name}: {value}")
        t.check(value["total_error"] >= value["statistical_error"], f"total error of {name}: {value}")
    t.equal(t.json("out/results.json"), data, "results.json")
    t.check(data["runs"]["equilibration_steps"] >= 2 * data["runs"]["equilibration_found"], f"runs: {data['runs']}")
    text = reference(t, *GAS, "--error", "energy=0.01,pressure=0.012").out
    t.contains(text, "Lennard-Jones fluid at T = 2, rho = 0.5: supercritical fluid")
    t.contains(text, "to cite:")
    t.contains(text, "files: out\n")
    t.check(text.startswith(t.read("out/results.txt")), "results.txt is another text")


def what_is_finished_is_kept(t):
    """The same request runs nothing; smaller errors make the runs longer, with the bits of a request that begins with them."""
    reference(t, *QUICK)
    before = snapshot(t.dir / "out" / "canonical" / "points")
    said = reference(t, *QUICK, quiet=False).err
    t.contains(said, "canonical: 2 runs of 10000 steps\n")
    t.equal(snapshot(t.dir / "out" / "canonical" / "points"), before, "the runs")
    smaller = (*GAS, "--replicas", "2", "--error", "energy=0.003")
    longer = found(t, *smaller)
    t.check(longer["runs"]["canonical"]["steps"] > 10000, f"steps: {longer['runs']}")
    t.equal(found(t, *smaller, out="at-once"), longer, "what a request finds that begins with the small error")


def what_was_stopped_is_resumed(t):
    """Stopped by Ctrl-C between and in runs, the values have the bits of a request that nothing has stopped."""
    smaller = (*GAS, "--replicas", "2", "--error", "energy=0.003")
    whole = found(t, *smaller, out="whole")
    record = t.dir / "out" / "canonical" / "sweep.json"

    def lengthened():
        return record.exists() and json.loads(record.read_text())["steps_added"] > 0

    for reached, what in ((record.exists, "its canonical runs"), (lengthened, "longer ones")):
        process = start(t, "reference", *smaller, "--out", "out", "--quiet")
        waiting.until(reached, what, process)
        process.send_signal(signal.SIGINT)
        t.equal(end(process).code, 130, "exit code")
    t.equal(found(t, *smaller), whole, "what was found after all")


def all_properties(t):
    data = found(t, *GAS, "--replicas", "2", "--max-steps", "12000", "--properties", "all", "--error", "energy=0.02")
    for name in ("heat_capacity_cv", "excess_chemical_potential", "diffusion", "viscosity", "bulk_viscosity",
                 "thermal_conductivity", "speed_of_sound", "joule_thomson_coefficient"):
        value = data[name]
        t.check(value["mean"] is None or value["statistical_error"] > 0, f"{name}: {value}")
        t.check(value["mean"] is not None or value["remark"], f"{name} has neither value nor remark")
    runs = data["runs"]
    t.check(max(runs["canonical"]["steps"], runs["transport"]["steps"]) <= 12000, f"--max-steps: {runs}")
    t.equal(data["viscosity"]["equation_of_state"], None, "viscosity by an equation of state")
    t.check(any("--max-steps ended the runs" in warning for warning in data["warnings"]), f"warnings: {data['warnings']}")
    t.equal(list(t.columns("out/rdf.csv"))[:2], ["r", "g"], "columns of rdf.csv")
    t.equal(list(t.columns("out/sk.csv"))[:2], ["k", "S"], "columns of sk.csv")


def from_a_pressure(t):
    data = found(t, "--temperature", "2", "--pressure", "1.075", "--atoms", "108", "--replicas", "2", "--error", "pressure=0.02")
    density = data["density"]
    t.check(abs(density["mean"] - 0.5) < 5 * density["total_error"] + 0.002, f"density: {density}")
    t.equal(data["asked_pressure"], 1.075, "pressure")
    t.contains(t.read("out/results.txt"), "p = 1.075 (runs at rho = ")


def refusals(t):
    """What cannot be vouched for, and what makes no sense, is refused before anything is written."""
    for code, arguments, reason in (
            (5, ("--temperature", "1", "--density", "0.3"), "separates into vapour and liquid"),
            (5, ("--temperature", "0.8", "--density", "1.1"), "the crystal is the stable phase"),
            (5, ("--temperature", "1.34", "--density", "0.31"), "too near the critical point"),
            (5, ("--temperature", "0.9", "--density", "0.74"), "metastable liquid"),
            (5, ("--temperature", "20", "--density", "0.5"), "outside of 0.661 to 9"),
            (5, ("--temperature", "0.8", "--density", "1e-5"), "hardly meet"),
            (2, ("--temperature", "1", "--density", "0.8", "--seed", "-1"), "--seed"),
            (2, ("--temperature", "1"), "a density or a pressure"),
            (2, ("--temperature", "1", "--density", "0.8", "--properties", "entropy"), "unknown property 'entropy'"),
            (2, ("--temperature", "1", "--density", "0.8", "--error", "D=0.1"), "not among the properties"),
            (2, ("--temperature", "1", "--density", "0.8", "--error", "energy"), "PROPERTY=NUMBER"),
            (2, ("--temperature", "1", "--density", "0.8", "--atoms", "100"), "100 atoms do not fill"),
            (2, ("--temperature", "1", "--density", "1.4 g/cm3"), "--density")):
        t.contains(t.expect(code, t.run("reference", *arguments, "--out", "out")).err, reason)
    t.equal(t.files(), [], "files")


def its_directory_is_known(t):
    """info, report and plot know the directory of a reference; resume and analyze say what takes it."""
    reference(t, *QUICK, "--properties", "g")
    t.contains(t.run_well("info", "out").out, "a reference of 4 runs")
    page = json.loads(t.run_well("report", "out", "--json").out)
    t.equal(page["kind"], "reference", "kind")
    t.equal([chart["id"] for chart in page["charts"]], ["apart", "errors", "rdf"], "charts")
    t.equal(dict(page["provenance"])["density of the runs"], "0.5", "provenance")
    t.run_well("plot", "out")
    for command in ("resume", "analyze"):
        t.contains(t.expect(3, t.run(command, "out")).err, "it holds a reference, which `ljmd reference` with the same options and --out out resumes")
    t.contains(t.run_well("resume", "out/canonical", "--quiet").out, "2 replicas, merged")


def another_request_is_refused(t):
    reference(t, *QUICK)
    other = ("--temperature", "2.5", "--density", "0.5", "--atoms", "108", "--replicas", "2", "--error", "energy=0.02")
    before = t.read("out/reference.json")
    t.contains(t.expect(2, t.run("reference", *other, "--out", "out")).err, "holds a reference with another value of temperature")
    t.contains(t.expect(2, t.run("reference", *QUICK, "--properties", "c_v", "--out", "out")).err, "another value of properties")
    t.equal(t.read("out/reference.json"), before, "reference.json")
    t.contains(t.expect(2, t.run("reference", *QUICK, "--out", "out/canonical")).err, "holds a sweep or replicas")
    t.equal(found(t, *QUICK)["temperature"], 2, "temperature")
    t.equal(found(t, *other, "--force")["temperature"], 2.5, "temperature")


def cases():
    return [Case(f"reference: {name.replace('_', ' ')}", test) for name, test in (
        ("values reach their errors", values_reach_their_errors), ("what is finished is kept", what_is_finished_is_kept),
        ("what was stopped is resumed", what_was_stopped_is_resumed), ("all properties", all_properties),
        ("from a pressure", from_a_pressure), ("refusals", refusals), ("another request is refused", another_request_is_refused),
        ("its directory is known", its_directory_is_known))]
