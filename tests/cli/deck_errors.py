"""Mistakes in a deck: each is refused before anything is run, with the message of the golden file."""

import re

from harness import ARGON, DECK, Case

BACK = '[[stage]]\nname = "back"\ntime_step = 0.004\nsteps = 40\nreverse = true\n'

# Each entry: name, (old, new) replacements in harness.DECK.
VALUES = [
    # not finite, out of range, no meaning
    ("density is nan", ("density = 0.8442", "density = nan")),
    ("density is inf", ("density = 0.8442", "density = inf")),
    ("density is 1e400", ("density = 0.8442", "density = 1e400")),
    ("density is negative", ("density = 0.8442", "density = -0.8")),
    ("density is zero", ("density = 0.8442", "density = 0.0")),
    ("density is minus zero", ("density = 0.8442", "density = -0.0")),
    ("density is 1e300", ("density = 0.8442", "density = 1e300")),
    ("density is 1e-320", ("density = 0.8442", "density = 1e-320")),
    ("temperature is nan", ("temperature = 1.0", "temperature = nan")),
    ("temperature is negative", ("temperature = 1.0", "temperature = -1.0")),
    ("temperature is 1e300", ("temperature = 1.0", "temperature = 1e300")),
    ("cutoff is nan", ("cutoff = 2.5", "cutoff = nan")),
    ("cutoff is zero", ("cutoff = 2.5", "cutoff = 0")),
    ("cutoff is negative", ("cutoff = 2.5", "cutoff = -2.5")),
    ("skin is negative", ("skin = 0.3", "skin = -0.1")),
    ("skin is larger than any box", ("skin = 0.3", "skin = 1e300")),
    ("cutoff is 1e-300", ("cutoff = 2.5", "cutoff = 1e-300")),
    ("skin is inf", ("skin = 0.3", "skin = inf")),
    ("time step is nan", ("time_step = 0.004\nsteps = 20", "time_step = nan\nsteps = 20")),
    ("time step is zero", ("time_step = 0.004\nsteps = 20", "time_step = 0.0\nsteps = 20")),
    ("time step is negative", ("time_step = 0.004\nsteps = 20", "time_step = -0.004\nsteps = 20")),
    ("time step is huge", ("time_step = 0.004\nsteps = 20", "time_step = 1e10\nsteps = 20")),
    ("steps is negative", ("steps = 40", "steps = -1")),
    ("cells is zero", ("cells = 3", "cells = 0")),
    ("cells is negative", ("cells = 3", "cells = -3")),
    ("seed is negative", ("seed = 7", "seed = -7")),
    ("thermo interval is zero", ("thermo = { every = 5 }", "thermo = { every = 0 }")),
    ("thermostat interval is zero", ("every = 5 }\n\n[[stage]]", "every = 0 }\n\n[[stage]]")),
    # of the wrong type
    ("string for a number", ("density = 0.8442", 'density = "dense"')),
    ("number in quotes", ("density = 0.8442", 'density = "0.8442"')),
    ("bool for a number", ("density = 0.8442", "density = true")),
    ("array for a number", ("density = 0.8442", "density = [0.8, 0.9]")),
    ("date for a number", ("density = 0.8442", "density = 1967-07-05")),
    ("table for a number", ("density = 0.8442", "density = { value = 0.8 }")),
    ("float for an integer", ("steps = 40", "steps = 40.0")),
    ("bool for an integer", ("steps = 40", "steps = true")),
    ("string for an integer", ("steps = 40", 'steps = "40"')),
    ("integer for a bool", ("sample = true", "sample = 1")),
    ("string for a bool", ("tail = true", 'tail = "true"')),
    ("number for a string", ('title = "small"', "title = 1967")),
    ("number for a choice", ('truncation = "cut"', "truncation = 1")),
    ("number for a table", ("thermo = { every = 5 }", "thermo = 5")),
    ("string for a table", ('lattice = { type = "fcc", cells = 3 }', 'lattice = "fcc"')),
    ("array of wrong elements", (DECK[DECK.index("[[stage]]"):DECK.index("[output]")], ""),
     ('title = "small"', 'title = "small"\nstage = [1, 2]')),
    ("one stage instead of an array", (DECK[DECK.index("[[stage]]"):DECK.index("[output]")],
                                       '[stage]\nname = "a"\ntime_step = 0.004\nsteps = 1\n\n')),
    ("no stage at all", (DECK[DECK.index("[[stage]]"):DECK.index("[output]")], ""),
     ('title = "small"', 'title = "small"\nstage = []')),
    # choices
    ("unknown potential", ('type = "lennard-jones"', 'type = "lenard-jones"')),
    ("unknown truncation", ('truncation = "cut"', 'truncation = "shifted-force"')),
    ("unknown lattice", ('type = "fcc"', 'type = "hcp"')),
    ("unknown thermostat", ('type = "rescale"', 'type = "nose-hoover"')),
    ("unknown integrator", ("steps = 40", 'steps = 40\nintegrator = "verlet-velocity"')),
    ("unknown pair search", ("skin = 0.3", 'skin = 0.3\nmethod = "list"')),
    ("unknown units of the deck", ('title = "small"', 'title = "small"\nunits = "real"')),
    # units
    ("unit without argon", ("temperature = 1.0", 'temperature = "86.5 K"')),
    ("unit of another dimension", ("temperature = 1.0", 'temperature = "86.5 bar"')),
    ("unknown unit", ("cutoff = 2.5", 'cutoff = "8.5 furlong"')),
    ("unit where there is none", ("seed = 7", 'seed = "7 K"')),
    ("unit for a key without dimension", ('type = "lennard-jones"',
                                          'type = "morse"\nsteepness = "6 nm"\nwell_depth = 1.0\nminimum = 1.1')),
    ("morse without its parameters", ('type = "lennard-jones"', 'type = "morse"')),
]

STRUCTURE = [
    ("unknown key", ("density = 0.8442", "densty = 0.8442")),
    ("unknown key without a likeness", ("density = 0.8442", "density = 0.8442\ngamma = 1.0")),
    ("unknown table", ("[neighbors]", "[neighbours]")),
    ("unknown table without a likeness", ("[neighbors]", "[gravity]\npressure = 1.0\n\n[neighbors]")),
    ("a table of stages at the top", ("[neighbors]", "[barostat]\npressure = 1.0\n\n[neighbors]")),
    ("a key of a table at the top", ('title = "small"', 'title = "small"\ncutoff = 2.5')),
    ("unknown key at the top", ('title = "small"', 'titel = "small"')),
    ("unknown key in an inner table", ("cells = 3", "cell = 3")),
    ("unknown key in a stage", ("steps = 40", "step = 40")),
    ("unknown key of a thermostat", ("every = 5 }\n\n[[stage]]", "tau = 0.1 }\n\n[[stage]]")),
    ("key of another potential", ("cutoff = 2.5", "cutoff = 2.5\nsteepness = 6.0")),
    ("key of another truncation", ("cutoff = 2.5", "cutoff = 2.5\nswitch_start = 2.0")),
    ("unknown key in quotes", ("density = 0.8442", 'density = 0.8442\n"a b" = 1')),
    ("key in capitals", ("density = 0.8442", "Density = 0.8442")),
    ("duplicate key", ("density = 0.8442", "density = 0.8442\ndensity = 0.9")),
    ("duplicate table", ("[output]", "[system]\ntemperature = 2.0\n\n[output]")),
    ("missing potential", (DECK[DECK.index("[potential]"):DECK.index("[neighbors]")], "")),
    ("missing system", (DECK[DECK.index("[system]"):DECK.index("[potential]")], "")),
    ("missing stages", (DECK[DECK.index("[[stage]]"):DECK.index("[output]")], "")),
    ("missing density", ("density = 0.8442\n", "")),
    ("missing temperature", ("temperature = 1.0\n", "")),
    ("missing cutoff", ("cutoff = 2.5\n", "")),
    ("missing truncation", ('truncation = "cut"\n', "")),
    ("missing tail", ("tail = true\n", "")),
    ("missing tail and switch_start", ('truncation = "cut"\ntail = true', 'truncation = "switched"')),
    ("missing name, time step and steps", ('name = "production"\ntime_step = 0.004\nsteps = 40\n', "")),
    ("missing lattice type", ('type = "fcc", ', "")),
    ("missing interval of the trajectory", ("[output]", '[output]\ntrajectory = { format = "xyz" }')),
    ("no closing bracket", ("[system]", "[system")),
    ("no closing quote", ('title = "small"', 'title = "small')),
    ("no value", ("density = 0.8442", "density =")),
    ("text without quotes", ('type = "lennard-jones"', "type = lennard-jones")),
    ("unit without quotes", ("temperature = 1.0", "temperature = 86.5 K")),
    ("decimal comma", ("density = 0.8442", "density = 0,8442")),
    ("two values", ("density = 0.8442", "density = 0.8 0.9")),
    ("line without a key", ("density = 0.8442", "0.8442")),
    ("inline table over two lines", ("thermo = { every = 5 }", "thermo = { every = 5\n}")),
    ("tab and wide characters before the mistake", ("density = 0.8442", '\t"ø" = 0.8442')),
    ("a very long line", ("density = 0.8442", "density = 0.8442\nlong = [" + "1, " * 400 + "1]")),
    ("an escape sequence in a key", ("density = 0.8442", 'density = 0.8442\n"\\u001b[31mred" = 1')),
]

SENSE = [
    ("kelvin in reduced units", ("temperature = 1.0", "temperature = 86.5")),
    ("kelvin in a stage", ("steps = 20", "steps = 20\ntemperature = 86.5")),
    ("Maxwell velocities without a temperature", ('lattice = { type = "fcc", cells = 3 }', 'file = "start.xyz"'),
     ("temperature = 1.0", 'velocities = "maxwell"')),
    ("time step of 0.02", ("time_step = 0.004\nsteps = 40", "time_step = 0.02\nsteps = 40")),
    ("sampled on the way back", ("[output]", BACK + "sample = true\n\n[output]")),
    ("sampled after the way back", ("[output]", BACK + "\n[[stage]]\nname = \"on\"\ntime_step = 0.004\nsteps = 40\nsample = true\n\n[output]")),
    ("cutoff above half the box", ("cutoff = 2.5", "cutoff = 3.0")),
    ("cutoff in angstrom", ("cutoff = 2.5", "cutoff = 8.5")),
    ("density above 1.5", ("density = 0.8442", "density = 1.6"), ("cutoff = 2.5", "cutoff = 2.0")),
    ("atoms do not fill a crystal", ("cells = 3", "atoms = 100")),
    ("atoms do not fill a simple cubic crystal", ('type = "fcc", cells = 3', 'type = "simple-cubic", atoms = 100')),
    ("no atoms", ("cells = 3", "atoms = 0")),
    ("atoms and cells", ("cells = 3", "cells = 3, atoms = 108")),
    ("neither atoms nor cells", (", cells = 3", "")),
    ("random start with cells", ('type = "fcc"', 'type = "random"')),
    ("random start without atoms", ('type = "fcc", cells = 3', 'type = "random"')),
    ("tail with a shifted potential", ('truncation = "cut"', 'truncation = "shifted"')),
    ("tail with a force-shifted potential", ('truncation = "cut"', 'truncation = "force-shifted"')),
    ("switch_start above the cutoff", ('truncation = "cut"', 'truncation = "switched"\nswitch_start = 2.6')),
    ("lattice and file", ("seed = 7", 'seed = 7\nfile = "start.xyz"')),
    ("neither lattice nor file", ('lattice = { type = "fcc", cells = 3 }\n', "")),
    ("velocities of a file that is not there", ("seed = 7", 'seed = 7\nvelocities = "file"')),
    ("two stages of one name", ('name = "melt"', 'name = "production"')),
    ("a stage without a name to speak of", ('name = "melt"', 'name = ""')),
    ("a stage named by an escape sequence", ('name = "melt"', 'name = "\\u001b[31m"')),
    ("si trajectory without argon", ("[output]", '[output]\ntrajectory = { every = 10, units = "si" }')),
    ("empty output directory", ("[output]", '[output]\ndirectory = ""')),
    ("rdf beyond half the box", ("[output]", "[analysis]\nrdf = { radius = 4.0 }\n\n[output]")),
    ("2^63 steps", ("steps = 40", "steps = 9223372036854775808")),
    ("2^63 - 1 steps", ("steps = 40", "steps = 9223372036854775807")),
    ("-2^63 steps", ("steps = 40", "steps = -9223372036854775808")),
    ("3e9 atoms", ('type = "fcc", cells = 3', 'type = "random", atoms = 3000000000')),
    ("4e9 atoms by their cells", ("cells = 3", "cells = 1000")),
    ("cells whose atoms overflow 64 bits", ("cells = 3", "cells = 9223372036854775807")),
]

# In a deck with an [argon] table.
SUBSTANCE = [
    ("angstrom as sigma", ("cutoff = 2.5", 'cutoff = "25 angstrom"')),
    ("sigma without a unit", ('sigma = "3.405 angstrom"', "sigma = 3.405")),
    ("sigma without a unit, in quotes", ('sigma = "3.405 angstrom"', 'sigma = "3.405"')),
    ("sigma in kelvin", ('sigma = "3.405 angstrom"', 'sigma = "3.405 K"')),
    ("sigma of zero", ('sigma = "3.405 angstrom"', 'sigma = "0 angstrom"')),
    ("epsilon negative", ('epsilon = "119.8 K"', 'epsilon = "-119.8 K"')),
    ("mass missing", ('mass = "39.948 u"\n', "")),
    ("mass of nan", ('mass = "39.948 u"', 'mass = "nan u"')),
    ("mass so small that the units overflow", ('mass = "39.948 u"', 'mass = "1e-300 u"')),
    ("sigma so small that the units overflow", ('sigma = "3.405 angstrom"', 'sigma = "1e-120 m"')),
    ("an unknown key in argon", ('mass = "39.948 u"', 'mass = "39.948 u"\ncolour = "blue"')),
    ("argon is no table", (ARGON, 'argon = "39.948 u"\n')),
    ("temperature in bar", ("temperature = 1.0", 'temperature = "86.5 bar"')),
    ("temperature of 1e5 K", ("temperature = 1.0", 'temperature = "100000 K"')),
    ("negative temperature", ("temperature = 1.0", 'temperature = "-5 K"')),
    ("density of a stone", ("density = 0.8442", 'density = "7.8 g/cm3"'), ("cutoff = 2.5", "cutoff = 1.5")),
]

SETTINGS = [
    ("--set of an unknown key", ["system.densty=0.8"]),
    ("--set of an unknown table", ["sistem.density=0.8"]),
    ("--set without the table", ["density=0.8", "temperature=1", "steps=5", "densty=0.7"]),
    ("--set without a value", ["system.density"]),
    ("--set with an empty value", ["system.density="]),
    ("--set without a key", ["=0.8"]),
    ("--set with an empty part", ["system..density=0.8"]),
    ("--set of the wrong type", ["system.density=dense"]),
    ("--set out of range", ["system.density=-1"]),
    ("--set of nan", ["system.density=nan"]),
    ("--set of a stage that is not there", ["stage.prodction.steps=10"]),
    ("--set of a stage without a name", ["stage.steps=10"]),
    ("--set of a whole table to a number", ["system=3"]),
    ("--set through a value", ["system.density.value=3"]),
    ("--set of a cutoff above half the box", ["potential.cutoff=3"]),
    ("--set of 2^63 steps", ["stage.production.steps=9223372036854775808"]),
    ("several --set, each with a mistake", ["system.densty=0.8", "stage.production.stps=1", "potential.cutoff=nan"]),
    ("--set and deck have mistakes", ["system.temperature=-1", "stage.melt.time_step=0.5"]),
]

MANY = """\
title = 5
unit = "reduced"

[system]
lattice = { type = "fc", cells = 3.5 }
densty = 0.8442
temperature = -1.0

[potential]
type = "lennard-jones"
cutoff = "2.5"
truncation = "none"

[[stage]]
name = "a"
time_step = 0.05
steps = -1

[[stage]]
name = "a"
time_step = "5 fs"
stps = 10
thermostat = { type = "rescale", evry = 5 }

[output]
thermo = { every = 0 }
trajectory = {}
"""


def refused(deck, *arguments):
    """The case of a deck that must be refused, untouched and with the golden message."""
    def test(t):
        for command in ("run", "check"):
            t.deck(*deck[1:], text=deck[0])
            result = t.expect(2, t.run(command, "deck.toml", *arguments))
            t.equal(result.out, "", f"stdout of {command}")
            t.check(re.search(r"\n\d+ errors?\. Nothing was run\.\n\Z", result.err), f"no closing line:\n{result.err}")
            t.check("error: error:" not in result.err, "'error:' twice")
            t.equal(t.files(), ["deck.toml"], "files")
            said = result.err if command == "run" else said
            t.equal(result.err, said, "what check says")
            t.golden(result.err)
    return test


def positions(text):
    return [tuple(map(int, m)) for m in re.findall(r"^error: deck\.toml:(\d+):(\d+): ", text, flags=re.M)]


def many_at_once(t):
    t.deck(text=MANY)
    result = t.expect(2, t.run("run", "deck.toml", "--set", "neighbors.skn=1"))
    found = positions(result.err)
    t.check(len(found) >= 10, f"only {len(found)} mistakes reported")
    t.equal(found, sorted(found), "order of the mistakes")
    t.golden(result.err)


def a_hundred_mistakes(t):
    t.deck(("title = \"small\"", "\n".join(f"key_{n} = {n}" for n in range(100))))
    result = t.expect(2, t.run("run", "deck.toml"))
    t.contains(result.err, "... and 50 more\n100 errors. Nothing was run.\n")


def deck_in_another_folder(t):
    (t.dir / "decks").mkdir()
    t.deck(("density = 0.8442", "densty = 0.8442"), name="decks/a b.toml")
    t.golden(t.expect(2, t.run("run", "decks/a b.toml")).err)


def cases():
    result = [Case(name, refused((DECK, *edits))) for name, *edits in VALUES + STRUCTURE + SENSE]
    substance = DECK.replace("[system]", ARGON + "\n[system]")
    result += [Case(name, refused((substance, *edits))) for name, *edits in SUBSTANCE]
    for name, settings in SETTINGS:
        edits = [("density = 0.8442", "density = 0.8442\nunknown = 1")] if "deck have" in name else []
        result.append(Case(name, refused((DECK, *edits), *[part for s in settings for part in ("--set", s)])))
    result += [Case("many mistakes at once", many_at_once), Case("a hundred mistakes", a_hundred_mistakes),
               Case("a deck in another folder", deck_in_another_folder)]
    return result
