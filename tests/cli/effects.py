"""Keys and options that have no effect are told of, and a temperature that is not the one that was asked for."""

from harness import ARGON, DECK, STARS, Case

LATTICE = 'lattice = { type = "fcc", cells = 3 }\n'
RESCALE = 'thermostat = { type = "rescale", every = 5 }\n'


def warned(name, *replacements, settings=(), text=DECK):
    """`ljmd check` of this deck says so, and does not refuse it."""
    def test(t):
        t.deck(*replacements, text=text)
        arguments = [part for setting in settings for part in ("--set", setting)]
        t.golden(t.run_well("check", "deck.toml", "--json", *arguments).err)
    return Case(name, test)


def temperature_of_a_start_with_velocities(t):
    """A start from another run has its velocities, not those of the deck's temperature: check, run and sweep warn."""
    t.deck()
    t.run_well("run", "deck.toml", "--quiet", "--out", "first")
    t.deck((LATTICE, 'file = "first"\n'), ("density = 0.8442\n", ""), ("seed = 7\n", ""), (RESCALE, ""),
           ("temperature = 1.0", "temperature = 3.0"))
    said = t.run_well("check", "deck.toml").err
    t.golden(said)
    result = t.run_well("run", "deck.toml", "--out", "second")
    t.check(result.err.startswith(said), f"run does not say it: {result.err}")
    t.contains(result.out, "asked 3, found 0.")
    swept = t.run_well("sweep", "deck.toml", "--grid", "system.temperature=2:3:2", "--out", "swept", "--jobs", "1")
    t.contains(swept.err, "warning: --grid system.temperature: 'temperature' in [system] has no effect")
    t.contains(swept.err, "(all 2 points)")
    t.deck((LATTICE, 'file = "first"\nvelocities = "maxwell"\n'), ("density = 0.8442\n", ""), (RESCALE, ""))
    t.equal(t.run_well("check", "deck.toml").err, "", "warnings when new velocities are drawn")


def options_without_effect(t):
    t.deck()
    t.run_well("run", "deck.toml", "--quiet", "--out", "run")
    refusals = ""
    for arguments in (("eos", "--model", "thol2015"), ("eos", "--temperature", "120K"), ("eos", "--temperature", "hot"),
                      ("eos", "--temperature", "1", "--density", "1.4 g/cm3"),
                      ("analyze", "run", "--set", "analysis.rdf.bins=10"), ("analyze", "run", "thermo", "--out", "x"),
                      ("analyze", "run", "rdf", "--from", "2ps"),
                      ("compare", "deck.toml", "--with", "lammps", "--platform", "CPU"),
                      ("compare", "deck.toml", "--with", "gsl", "--steps", "10"),
                      ("compare", "deck.toml", "--with", "openmm", "--parts", "point", "--steps", "10"),
                      ("check", "deck.toml", "--set", "analysis..bins=3")):
        result = t.expect(2, t.run(*arguments))
        t.equal(result.out, "", "stdout")
        refusals += f"$ ljmd {' '.join(arguments)}\n{result.err}"
    t.golden(refusals)


def thermo_of_a_trajectory_has_no_settings(t):
    t.deck(("thermo = { every = 5 }", 'trajectory = { format = "xyz", every = 5, velocities = true }'))
    t.run_well("run", "deck.toml", "--quiet", "--out", "run")
    result = t.expect(2, t.run("analyze", "run/trajectory.xyz", "thermo", "--deck", "deck.toml", "--set", "analysis.rdf.bins=3"))
    t.equal(result.err, "error: --set analysis.rdf.bins=3: thermo has no settings\n", "stderr")


def the_temperature_that_was_asked(t):
    """At constant energy the temperature is a result: the table says what was asked, and what the rest is there."""
    t.deck(("cells = 3", "cells = 4"), ("density = 0.8442", "density = 0.75"), ("steps = 20\n", "steps = 1000\n"),
           ("steps = 40", "steps = 1000"))
    result = t.run_well("run", "deck.toml", "--out", "out", "--set", "stage.melt.temperature=1.05", "--set", "system.temperature=1.05")
    found = t.json("out/results.json")
    t.equal(found["asked_temperature"], 1.05, "asked_temperature")
    temperature = found["observables"]["temperature"]
    off = abs(temperature["mean"] - 1.05) > 3 * temperature["standard_error"]
    t.equal("remark" in temperature, off, "remark")
    if off:  # whether it is, depends on the processor's rounding
        t.contains(result.out, "[1] asked 1.05, found ")
    t.equal(found["at_asked_temperature"] is not None, "brought to T = 1.05" in result.out, "lines below the table")
    # Under a canonical thermostat nothing has to be brought anywhere.
    t.run_well("run", "deck.toml", "--out", "held", "--quiet", "--set",
               'stage.production.thermostat={ type = "stochastic-rescaling" }')
    t.equal(t.json("held/results.json")["at_asked_temperature"], None, "at_asked_temperature under a thermostat")


def a_large_drift(t):
    """An integrator of first order heats the fluid: the table, results.json and stderr say so, of a good one they do not."""
    t.deck(("steps = 40\n", 'steps = 400\nintegrator = "euler"\n'), ("time_step = 0.004\nsteps = 400", "time_step = 0.0005\nsteps = 400"))
    result = t.run_well("run", "deck.toml", "--out", "out")
    t.contains(result.err, "warning: the energy drifts in stage 'production': in all ")
    t.contains(result.out, "% of the kinetic energy: too much; a smaller time step")
    t.contains(t.json("out/results.json")["stages"][1]["energy_drift_remark"], "too much")
    good = t.run_well("run", "deck.toml", "--out", "good", "--set", "stage.production.integrator=velocity-verlet")
    t.check("drifts" not in good.err, good.err)
    t.check("energy_drift_remark" not in t.json("good/results.json")["stages"][1], "remark on a small drift")


def cases():
    tests = (temperature_of_a_start_with_velocities, options_without_effect, thermo_of_a_trajectory_has_no_settings,
             the_temperature_that_was_asked, a_large_drift)
    return [Case(test.__name__.replace("_", " "), test) for test in tests] + [
        warned("a temperature that only the first velocities have", (RESCALE, "temperature = 0.722\n" + RESCALE),
               settings=["system.temperature=1.744"]),
        warned("the same in kelvin", (RESCALE, "temperature = 0.722\n" + RESCALE), ('title = "small"\n', f'title = "small"\n{ARGON}'),
               settings=["system.temperature=86.5 K"]),
        warned("a temperature without a thermostat", ("sample = true", "sample = true\ntemperature = 2.0")),
        warned("a skin without a list", ("skin = 0.3", 'skin = 0.3\nmethod = "cells"')),
        warned("a thermostat that never acts", ("every = 5 }\n\n[[stage]]", "every = 21 }\n\n[[stage]]")),
        warned("nothing is sampled", ("sample = true\n", "")),
        warned("nothing is sampled, though much is asked for", ("sample = true\n", ""), ("[output]", "[analysis]\nrdf = {}\n\n[output]")),
        warned("a sampled stage without a row", ("thermo = { every = 5 }", "thermo = { every = 100 }")),
        warned("an analysis that never looks", ("[output]", "[analysis]\nrdf = { every = 100 }\n\n[output]")),
        warned("a trajectory of the start alone", ("[output]", "[output]\ntrajectory = { every = 100 }")),
        warned("a setting that comes twice", settings=["system.seed=1", "system.seed=2"]),
        warned("sample without an analysis", ("steps = 100", "steps = 100\nsample = false"), text=STARS),
        warned("velocities that a table has anyway", ("[output]", "[output]\ntrajectory = { every = 10, velocities = false }"),
               text=STARS),
        warned("gravity on one body", ("[[body]]\nmass = 1.5\nposition = [2.0, 0.0]\nvelocity = [0.0, 1.0]\n", ""), text=STARS),
    ]
