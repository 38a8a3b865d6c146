"""ljmd eos: what equations of state say, and what they refuse."""

import json

from harness import Case


def every_equation_is_listed(t):
    listed = json.loads(t.run_well("eos", "--json").out)
    table = t.run_well("eos").out
    names = [row["model"] for row in listed]
    t.equal(names, ["johnson1993", "kolafa-nezbeda1994", "thol2015", "thol2016"], "equations")
    t.equal([line.split()[0] for line in table.splitlines()[1:]], names, "equations of the table")
    for row in listed:
        t.contains(table, f"{row['critical_temperature']:.4f}")
        t.check(row["source"].count("doi:") == 1, f"source: {row['source']}")


def a_state(t):
    """Liquid argon near its triple point; the values are those of another implementation."""
    arguments = ("eos", "--temperature", "0.722", "--density", "0.8442")
    found = json.loads(t.run_well(*arguments, "--json").out)
    for key, value in (("pressure", 0.165), ("compressibility_factor", 0.271), ("potential_energy", -6.080),
                       ("heat_capacity_cv", 2.63)):
        t.check(abs(found[key] - value) < 0.005 * abs(value), f"{key}: {found[key]}")
    t.equal(found["warnings"], [], "warnings")
    t.equal(found["model"], "thol2016", "model")
    text = t.run_well(*arguments)
    t.equal(text.err, "", "stderr")
    t.contains(text.out, f"{found['pressure']:.9g}  epsilon/sigma^3")
    other = json.loads(t.run_well(*arguments, "--json", "--model", "thol2015").out)
    t.check(other["pressure"] > found["pressure"] + 0.5, f"of the truncated fluid: {other['pressure']}")


def coexistence(t):
    arguments = ("eos", "--temperature", "0.9")
    found = json.loads(t.run_well(*arguments, "--json").out)
    t.check(abs(found["liquid"]["density"] - 0.752773) < 1e-6, f"liquid: {found['liquid']['density']}")
    t.check(abs(found["vapour"]["density"] - 0.0144619) < 1e-7, f"vapour: {found['vapour']['density']}")
    for phase in ("liquid", "vapour"):
        t.check(abs(found[phase]["pressure"] - found["pressure"]) < 1e-12, f"pressure of the {phase}")
    text = t.run_well(*arguments).out
    t.contains(text, f"{found['heat_of_vaporisation']:.9g}  epsilon\n")


def what_no_temperature_has(t):
    """At density zero and where no phase is stable, JSON has null and the table a dash."""
    found = json.loads(t.run_well("eos", "--temperature", "0.9", "--density", "0", "--json").out)
    t.equal((found["compressibility_factor"], found["speed_of_sound"]), (1.0, None), "Z and speed of sound at density zero")
    t.contains(t.run_well("eos", "--temperature", "0.9", "--density", "0").out, "-  sqrt(epsilon/m)")


def warned(*arguments):
    def test(t):
        result = t.run_well("eos", *arguments)
        t.check(result.out, "nothing is printed")
        t.golden(result.err)
        found = json.loads(t.run_well("eos", *arguments, "--json").out)
        said = "".join(f"warning: {text}\n" for text in found.get("warnings", []))
        t.equal(said or result.err, result.err, "warnings")
    return test


def refused(code, *arguments):
    def test(t):
        result = t.expect(code, t.run("eos", *arguments))
        t.equal(result.out, "", "stdout")
        t.golden(result.err)
    return test


def cases():
    return [Case(test.__name__.replace("_", " "), test)
            for test in (every_equation_is_listed, a_state, coexistence, what_no_temperature_has)] + [
        Case("too cold", warned("--temperature", "0.5", "--density", "0.9")),
        Case("too dense", warned("--temperature", "2", "--density", "1.3", "--model", "johnson1993")),
        Case("too high a pressure", warned("--temperature", "5", "--density", "1.3")),
        Case("above freezing", warned("--temperature", "0.722", "--density", "0.9")),
        Case("above melting", warned("--temperature", "0.722", "--density", "1.0")),
        Case("between liquid and vapour", warned("--temperature", "0.9", "--density", "0.3")),
        Case("coexistence below the triple point", warned("--temperature", "0.5")),
        Case("coexistence above the critical temperature", refused(2, "--temperature", "1.4")),
        Case("a density alone", refused(2, "--density", "0.8")),
        Case("a negative temperature", refused(2, "--temperature", "-1", "--density", "0.8")),
        Case("a negative density", refused(2, "--temperature", "1", "--density", "-0.8")),
        Case("a temperature that is no number", refused(2, "--temperature", "nan", "--density", "0.8")),
        Case("a temperature that is a word", refused(2, "--temperature", "hot")),
        Case("an unknown equation", refused(2, "--temperature", "1", "--density", "0.8", "--model", "thol")),
        Case("packed beyond what is possible", refused(5, "--temperature", "1", "--density", "3", "--model", "kolafa-nezbeda1994"))]
