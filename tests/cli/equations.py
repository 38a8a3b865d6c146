"""ljmd eos: what equations of state say, and what they refuse."""

import csv
import io
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


def from_a_pressure(t):
    """The density comes back; below the vapour pressure the liquid is metastable, and the text names it."""
    state = json.loads(t.run_well("eos", "--temperature", "1.5", "--density", "0.5", "--json").out)
    found = json.loads(t.run_well("eos", "--temperature", "1.5", "--pressure", str(state["pressure"]), "--json").out)
    t.check(abs(found["density"] - 0.5) < 1e-12, f"density: {found['density']}")
    t.equal((found["phase"], found["metastable"]), ("fluid", []), "phases")
    for key in ("isothermal_compressibility", "thermal_expansion", "joule_thomson_coefficient"):
        t.check(abs(found[key] - state[key]) < 1e-9 * abs(state[key]), f"{key}: {found[key]}")
    arguments = ("eos", "--temperature", "0.9", "--pressure", "0.0115")
    found = json.loads(t.run_well(*arguments, "--json").out)
    t.equal((found["phase"], found["pressure"]), ("vapour", 0.0115), "stable phase")
    other, = found["metastable"]
    t.equal(other["phase"], "liquid", "metastable phase")
    t.check(0.0 < other["gibbs_energy_difference"] < 0.1, f"Gibbs energy: {other['gibbs_energy_difference']}")
    t.contains(t.run_well(*arguments).out, f"metastable: liquid of density {other['density']:.6g}, its Gibbs energy is higher by")


def coexistence_from_a_pressure(t):
    found = json.loads(t.run_well("eos", "--pressure", "0.0118130", "--json").out)
    t.check(abs(found["temperature"] - 0.9) < 1e-4, f"temperature: {found['temperature']}")
    t.check(abs(found["liquid"]["density"] - 0.75277) < 1e-4, f"liquid: {found['liquid']['density']}")


def near_the_critical_point(t):
    """Values down to rounding; they are those of arithmetic with 60 digits."""
    for arguments, temperature, pressure, vapour, liquid in (
            (("--temperature", "1.32000034695"), 1.32000034695, 0.1300604047126981, 0.313166936559482, 0.313233328843815),
            (("--temperature", "1.08599998", "--model", "thol2015"), 1.08599998, 0.1007658281353804, 0.318906574301951,
             0.319093451870188),
            (("--temperature", "1.33964782", "--model", "kolafa-nezbeda1994"), 1.33964782, 0.140530372906318, 0.310750404303896,
             0.310857399236398),
            (("--pressure", "0.1300604"), 1.3200003383311293, 0.1300604, 0.31262874076793, 0.31372326746816)):
        found = json.loads(t.run_well("eos", *arguments, "--json").out)
        for name, value, right, of in (("temperature", found["temperature"], temperature, 1e-13),
                                       ("pressure", found["pressure"], pressure, 1e-13),
                                       ("vapour", found["vapour"]["density"], vapour, 3e-8),
                                       ("liquid", found["liquid"]["density"], liquid, 3e-8)):
            t.check(abs(value / right - 1.0) < of, f"{arguments}, {name}: {value}, right {right}")
    t.contains(t.expect(2, t.run("eos", "--temperature", "1.32000034699")).err, "critical temperature of thol2016, 1.3200003469821535;")
    t.contains(t.expect(2, t.run("eos", "--pressure", "0.1300604047302798")).err, "critical")


def a_range(t):
    """A table, whose numbers are those of the states one by one; CSV and JSON have all of them."""
    arguments = ("eos", "--temperature", "0.7:1.3:7", "--density", "0.01|0.8")
    points = json.loads(t.run_well(*arguments, "--json").out)["points"]
    t.equal([(point["temperature"], point["density"]) for point in points],
            [(round(0.7 + 0.1 * k, 1), rho) for k in range(7) for rho in (0.01, 0.8)], "points")
    one = json.loads(t.run_well("eos", "--temperature", "1.2", "--density", "0.8", "--json").out)
    t.equal({**{key: one[key] for key in one if key not in ("model", "source")}, "failure": None}, points[11], "a point")
    rows = list(csv.DictReader(io.StringIO(t.run_well(*arguments, "--csv").out)))
    t.equal(len(rows), 14, "rows")
    for row, point in zip(rows, points):
        for key, value in point.items():
            if isinstance(value, float):
                t.equal(float(row[key]), value, key)
        t.equal(row["warnings"], "; ".join(point["warnings"]), "warnings")
    text = t.run_well(*arguments).out
    t.check(max(map(len, text.splitlines()[3:])) <= 80, f"wider than a terminal:\n{text}")
    t.golden(text)


def a_range_of_coexistence(t):
    """A temperature at which there is none has a reason instead of numbers."""
    text = t.run_well("eos", "--temperature", "0.8:1.4:4").out
    t.golden(text)
    rows = list(csv.DictReader(io.StringIO(t.run_well("eos", "--pressure", "0.01|0.2", "--csv").out)))
    t.check(float(rows[0]["liquid_density"]) > 0.7 and "critical pressure" in rows[1]["failure"], f"rows: {rows}")
    t.equal(rows[1]["liquid_density"], "", "a value of nothing")
    row, = csv.DictReader(io.StringIO(t.run_well("eos", "--temperature", "0.9", "--pressure", "0.0115", "--csv").out))
    t.check(row["phase"] == "vapour" and row["metastable"].startswith("liquid of density 0.75"), f"row: {row}")


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
            for test in (every_equation_is_listed, a_state, coexistence, what_no_temperature_has, from_a_pressure,
                         coexistence_from_a_pressure, near_the_critical_point, a_range, a_range_of_coexistence)] + [
        Case("too cold", warned("--temperature", "0.5", "--density", "0.9")),
        Case("too dense", warned("--temperature", "2", "--density", "1.3", "--model", "johnson1993")),
        Case("too high a pressure", warned("--temperature", "5", "--density", "1.3")),
        Case("above freezing", warned("--temperature", "0.722", "--density", "0.9")),
        Case("above melting", warned("--temperature", "0.722", "--density", "1.0")),
        Case("between liquid and vapour", warned("--temperature", "0.9", "--density", "0.3")),
        Case("coexistence below the triple point", warned("--temperature", "0.5")),
        Case("coexistence above the critical temperature", refused(2, "--temperature", "1.4")),
        Case("a density alone", refused(2, "--density", "0.8")),
        Case("a density and a pressure", refused(2, "--temperature", "1", "--density", "0.8", "--pressure", "1")),
        Case("a pressure of zero", refused(2, "--temperature", "1", "--pressure", "0")),
        Case("a pressure that is a word", refused(2, "--temperature", "1", "--pressure", "5 bar")),
        Case("coexistence above the critical pressure", refused(2, "--pressure", "0.2")),
        Case("coexistence below all vapour pressures", refused(5, "--pressure", "1e-30")),
        Case("a pressure that the equation does not reach", refused(5, "--temperature", "1", "--pressure", "1e9")),
        Case("a range of two parts", refused(2, "--temperature", "0.7:1.3")),
        Case("a range with a word", refused(2, "--temperature", "0.7:hot:3")),
        Case("a list with a value twice", refused(2, "--temperature", "0.7|0.7")),
        Case("a range from a negative number", refused(2, "--temperature", "-1:1:3")),
        Case("CSV and JSON", refused(2, "--temperature", "1", "--csv", "--json")),
        Case("a negative temperature", refused(2, "--temperature", "-1", "--density", "0.8")),
        Case("a negative density", refused(2, "--temperature", "1", "--density", "-0.8")),
        Case("a temperature that is no number", refused(2, "--temperature", "nan", "--density", "0.8")),
        Case("a temperature that is a word", refused(2, "--temperature", "hot")),
        Case("an unknown equation", refused(2, "--temperature", "1", "--density", "0.8", "--model", "thol")),
        Case("packed beyond what is possible", refused(5, "--temperature", "1", "--density", "3", "--model", "kolafa-nezbeda1994"))]
