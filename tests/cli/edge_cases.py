"""Decks at the edge of what is allowed: these must run, and give finite results."""

import math
import re

from harness import DECK, Case

LONE = """\
[system]
lattice = { type = "simple-cubic", cells = 1 }
density = 0.001
temperature = 1.0

[potential]
type = "lennard-jones"
cutoff = 2.5
truncation = "cut"
tail = false

[[stage]]
name = "fly"
time_step = 0.004
steps = 50
sample = true
"""


#: All analyses, for runs of 400 steps of 0.004 tau.
ANALYSES = """
[analysis]
rdf = { bins = 10, every = 5 }
structure_factor = { k_max = 6.0, every = 20 }
msd = { max_time = 0.2, every = 5, fit_start = 0.1 }
vacf = { max_time = 0.2 }
viscosity = { max_time = 0.2 }
chemical_potential = { insertions = 10, every = 20 }
"""


def observables(t, directory="runs/deck"):
    """The observables of a run; every number in them is finite or null, and where there is none it is said why."""
    found = t.json(f"{directory}/results.json")["observables"]
    for name, values in found.items():
        for key in ("mean", "standard_error", "independent_samples"):
            t.check(values[key] is None or math.isfinite(values[key]), f"{name} {key} is {values[key]}")
        t.check(values["mean"] is not None or values.get("remark"), f"{name} has no value, and nobody says why")
    return found


def nothing_undefined(t, directory):
    """No table, no results.txt of a run shows a number that is none."""
    for path in (t.dir / directory).iterdir():
        if path.suffix in (".csv", ".txt"):
            words = re.split(r"[\s,]+", path.read_text().lower())
            t.check(not {"nan", "-nan", "inf", "-inf"} & set(words), f"{path.name} shows a number that is none")


def run_deck(t, *replacements, text=DECK, force=False):
    t.deck(*replacements, text=text)
    t.run_well("run", "deck.toml", "--quiet", *(["--force"] if force else []))
    return observables(t)


def one_atom(t):
    found = run_deck(t, text=LONE)
    t.equal(found["temperature"]["mean"], None, "temperature of one atom")
    t.equal(found["potential_energy"]["mean"], 0.0, "potential energy")
    t.equal(found["kinetic_energy"]["mean"], 0.0, "kinetic energy: one atom is its own centre of mass")
    for name in ("pressure", "compressibility_factor", "pressure_xx", "pressure_yz"):
        t.equal(found[name]["mean"], None, f"{name} of one atom")
    columns = t.columns("runs/deck/thermo.csv")
    for name in ("temperature", "pressure", "pressure_xx", "pressure_xy"):
        t.check(all(v is None for v in columns[name]), f"thermo.csv has a {name}")
    t.check(re.search(r"temperature +T +no value", (t.dir / "runs/deck/results.txt").read_text()),
            "results.txt has a temperature")


def one_atom_in_every_analysis(t):
    for name, thermostat in (("nve", ""), ("langevin", 'thermostat = { type = "langevin" }')):
        t.deck(("steps = 50", "steps = 400"), ("sample = true", f"sample = true\n{thermostat}\n{ANALYSES}"), text=LONE)
        t.run_well("run", "deck.toml", "--quiet", "--out", name)
        found = observables(t, name)
        for observable in ("viscosity", "diffusion_infinite_system", "heat_capacity_cv"):
            t.equal(found[observable]["mean"], None, f"{observable} of one atom")
        nothing_undefined(t, name)
        t.run_well("analyze", name)


def atoms_at_rest(t):
    """What is divided by the temperature has no value where that is zero but for rounding."""
    t.deck(("temperature = 1.0", "temperature = 0.0"), ("steps = 40", "steps = 400"), text=DECK + ANALYSES)
    t.run_well("run", "deck.toml", "--quiet")
    found = observables(t)
    for observable in ("compressibility_factor", "heat_capacity_cv", "viscosity", "diffusion_infinite_system",
                       "excess_chemical_potential"):
        t.equal(found[observable]["mean"], None, f"{observable} of atoms at rest")
    t.check(math.isfinite(found["pressure"]["mean"]), "pressure of a crystal at rest")
    nothing_undefined(t, "runs/deck")
    t.run_well("analyze", "runs/deck")


def two_atoms(t):
    found = run_deck(t, ('type = "simple-cubic", cells = 1', 'type = "random", atoms = 2'), text=LONE)
    t.check(found["temperature"]["mean"] > 0, "temperature of two atoms")


def zero_temperature(t):
    found = run_deck(t, ("temperature = 1.0", "temperature = 0.0"))
    t.check(abs(found["kinetic_energy"]["mean"]) < 1e-20, "a crystal at rest moves")


def minus_zero(t):
    run_deck(t, ("temperature = 1.0", "temperature = -0.0"), ("skin = 0.3", "skin = -0.0"))


def no_steps(t):
    found = run_deck(t, ("steps = 20", "steps = 0"), ("steps = 40", "steps = 0"))
    for name in ("potential_energy", "pressure", "virial"):
        t.check(math.isfinite(found[name]["mean"]), name)
        t.equal(found[name]["standard_error"], None, f"error of {name}")
    t.equal(t.columns("runs/deck/thermo.csv")["step"], [0.0], "rows of thermo.csv")


def no_zero_has_a_sign(t):
    """The displacements of a crystal that nothing has moved, in the table and in JSON."""
    t.deck(("steps = 20", "steps = 0"), ("steps = 40", "steps = 0"))
    with (t.dir / "deck.toml").open("a") as deck:
        deck.write("\n[analysis]\ncrystal = {}\n")
    found = t.run_well("run", "deck.toml", "--quiet", "--out", "out")
    for text in (found.out, t.read("out/results.json"), t.read("out/results.txt")):
        t.equal(re.findall(r"(?<![\w.])-0(?:\.0*)?(?![\d.])", text), [], "zeros with a sign")


def no_steps_in_one_stage(t):
    run_deck(t, ("steps = 20", "steps = 0"))
    t.equal([stage["steps"] for stage in t.json("runs/deck/results.json")["stages"]], [0, 40], "steps of the stages")


def largest_cutoff(t):
    """What the message calls the largest cutoff is allowed; a number that no rounding explains is not."""
    t.deck(("cutoff = 2.5", "cutoff = 3.0"))
    message = t.expect(2, t.run("run", "deck.toml")).err
    largest = message.split("largest allowed: ")[1].split()[0]
    t.deck(("cutoff = 2.5", f"cutoff = {largest}"), ("skin = 0.3", "skin = 0.5"))
    t.run_well("run", "deck.toml", "--quiet")
    t.deck(("cutoff = 2.5", f"cutoff = {float(largest) * (1.0 + 1e-11)!r}"))
    t.expect(2, t.run("run", "deck.toml", "--out", "more"))


def all_searches_agree(t):
    """With cutoff + skin > L/2 a list holds an atom and its image; the forces are those of all pairs."""
    virials = []
    for method in ("verlet-list", "cells", "all-pairs"):
        t.deck(("skin = 0.3", f'skin = 2.0\nmethod = "{method}"'))
        t.run_well("run", "deck.toml", "--quiet", "--out", method)
        virials.append(observables(t, method)["virial"]["mean"])
    t.check(max(virials) - min(virials) < 1e-8 * abs(virials[0]), f"virials {virials}")


def no_skin(t):
    run_deck(t, ("skin = 0.3", "skin = 0"))


def largest_seed(t):
    run_deck(t, ("seed = 7", "seed = 9223372036854775807"))


def simple_cubic(t):
    run_deck(t, ('type = "fcc", cells = 3', 'type = "simple-cubic", atoms = 216'))
    t.equal(t.json("runs/deck/results.json")["system"]["atoms"], 216, "atoms")


def atoms_instead_of_cells(t):
    run_deck(t, ("cells = 3", "atoms = 108"))


def no_sample(t):
    run_deck(t, ("sample = true", "sample = false"))
    warnings = t.json("runs/deck/results.json")["warnings"]
    t.check(any("no sample was taken" in warning for warning in warnings), f"warnings: {warnings}")


def units_in_the_deck(t):
    """The same deck in kelvin and g/cm3 and in reduced units runs the same trajectory, to round-off."""
    argon = '[argon]\nsigma = "3.405 angstrom"\nepsilon = "119.8 K"\nmass = "39.948 u"\n\n[system]'
    found = run_deck(t, ("[system]", argon), ("temperature = 1.0", 'temperature = "119.8 K"'),
                     ("cutoff = 2.5", 'cutoff = "8.5125 angstrom"'), ("skin = 0.3", 'skin = "1.0215 angstrom"'))
    t.check(abs(found["temperature"]["si"]["mean"] - 119.8 * found["temperature"]["mean"]) < 1e-9, "temperature in K")
    t.deck()
    t.run_well("run", "deck.toml", "--quiet", "--out", "reduced")
    reduced = observables(t, "reduced")
    for name in ("temperature", "potential_energy", "pressure"):
        a, b = found[name]["mean"], reduced[name]["mean"]
        t.check(abs(a - b) < 1e-6 * (1 + abs(b)), f"{name}: {a} in SI, {b} in reduced units")


def text_variants(t):
    """CRLF, a byte order mark and a missing last line end are no mistakes."""
    (t.dir / "deck.toml").write_bytes(b"\xef\xbb\xbf" + DECK.replace("\n", "\r\n").rstrip().encode())
    t.run_well("run", "deck.toml", "--quiet")


def settings(t):
    """--set reaches tables, stages by name and new keys; texts need no quotes."""
    t.deck()
    t.run_well("run", "deck.toml", "--quiet", "--out", "out", "--set", "system.density=0.8", "--set",
               "stage.production.steps=15", "--set", "potential.truncation=force-shifted", "--set", "potential.tail=false",
               "--set", "analysis.rdf.bins=20", "--set", "analysis.rdf.every=5", "--set", "title=set")
    results = t.json("out/results.json")
    t.check(abs(results["system"]["density"] - 0.8) < 1e-12, "density")
    t.equal(results["stages"][1]["steps"], 15, "steps")
    t.equal(results["title"], "set", "title")
    t.equal(len(t.columns("out/rdf.csv")["r"]), 20, "rows of rdf.csv")
    t.equal(len(t.json("out/run.json")["settings"]), 7, "settings in run.json")


def cases():
    return [Case(test.__name__.replace("_", " "), test)
            for test in (one_atom, one_atom_in_every_analysis, two_atoms, zero_temperature, atoms_at_rest, minus_zero, no_steps, no_zero_has_a_sign, no_steps_in_one_stage, largest_cutoff,
                         all_searches_agree, no_skin, largest_seed, simple_cubic, atoms_instead_of_cells, no_sample,
                         units_in_the_deck, text_variants, settings)]
