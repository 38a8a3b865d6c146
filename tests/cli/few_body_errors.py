"""Mistakes in a deck of a few bodies: each is refused before anything is run, with the message of the golden file."""

import re

from deck_errors import refused
from harness import STARS, Case

BODY = STARS[STARS.index("[[body]]"):STARS.index("[[body]]", STARS.index("[[body]]") + 1)]
STAGE = STARS[STARS.index("[[stage]]"):STARS.index("[output]")]
GRAVITY = 'type = "newtonian-gravity"\ngravitational_constant = 1.0\n'

# Each entry: name, (old, new) replacements in harness.STARS.
VALUES = [
    ("mass of zero", ("mass = 3.0", "mass = 0.0")),
    ("negative mass", ("mass = 3.0", "mass = -3.0")),
    ("mass of nan", ("mass = 3.0", "mass = nan")),
    ("mass of inf", ("mass = 3.0", "mass = inf")),
    ("mass with a unit", ("mass = 3.0", 'mass = "3 kg"')),
    ("missing mass", ("mass = 3.0\n", "")),
    ("missing position", ("position = [-1.0, 0.0]\n", "")),
    ("missing velocity", ("velocity = [0.0, -0.5]\n", "")),
    ("empty position", ("position = [-1.0, 0.0]", "position = []")),
    ("position with a string in it", ("position = [-1.0, 0.0]", 'position = [-1.0, "zero"]')),
    ("position with an array in it", ("position = [-1.0, 0.0]", "position = [-1.0, [0.0]]")),
    ("position that is a number", ("position = [-1.0, 0.0]", "position = -1.0")),
    ("position of four components", ("position = [-1.0, 0.0]", "position = [-1.0, 0.0, 0.0, 0.0]")),
    ("position with nan", ("position = [-1.0, 0.0]", "position = [-1.0, nan]")),
    ("position beyond numbers", ("position = [-1.0, 0.0]", "position = [-1.0, 1e200]")),
    ("negative softening", ("softening = 0.0", "softening = -0.1")),
    ("negative gravitational constant", ("gravitational_constant = 1.0", "gravitational_constant = -1.0")),
    ("time step of zero", ("time_step = 0.01", "time_step = 0.0")),
    ("time step with a unit", ("time_step = 0.01", 'time_step = "5 fs"')),
    ("thermo interval of zero", ("every = 10", "every = 0")),
    ("unknown integrator", ("steps = 100", 'steps = 100\nintegrator = "runge-kutta"')),
    ("integrator misspelled", ("steps = 100", 'steps = 100\nintegrator = "velocity-verlett"')),
    ("unknown force", (GRAVITY + "softening = 0.0\n", 'type = "coulomb"\n')),
    ("unknown format of a trajectory", ("[output]", '[output]\ntrajectory = { every = 1, format = "pdb" }')),
]

STRUCTURE = [
    ("missing force", ("[force]\n" + GRAVITY + "softening = 0.0\n", "")),
    ("missing bodies", (STARS[STARS.index("[[body]]"):STARS.index("[[stage]]")], "")),
    ("no body at all", (STARS[STARS.index("[[body]]"):STARS.index("[[stage]]")], ""),
     ('title = "stars"', 'title = "stars"\nbody = []')),
    ("one body instead of an array", (BODY, ""), ("[[body]]", "[body]")),
    ("missing stages", (STAGE, "")),
    ("no stage at all", (STAGE, ""), ('title = "stars"', 'title = "stars"\nstage = []')),
    ("missing type of the force", ('type = "newtonian-gravity"\n', "")),
    ("missing gravitational constant", ("gravitational_constant = 1.0\n", "")),
    ("key of another force", ("softening = 0.0", "stiffness = 1.0")),
    ("unknown key of a body", ("mass = 3.0", "mass = 3.0\nradius = 0.1")),
    ("body with a misspelled key", ("position = [-1.0, 0.0]", "positon = [-1.0, 0.0]")),
    ("start for an integrator that has none", ("steps = 100", 'steps = 100\nstart = "euler"')),
    ("unknown start", ("steps = 100", 'steps = 100\nintegrator = "position-verlet"\nstart = "midpoint"')),
    ("thermostat for a few bodies", ("steps = 100", 'steps = 100\nthermostat = { type = "rescale", every = 5 }')),
    ("temperature for a few bodies", ("steps = 100", "steps = 100\ntemperature = 1.0")),
    ("system and force", ("[force]", "[system]\ndensity = 0.8\n\n[force]")),
    ("potential and bodies", ("[force]", "[potential]\ncutoff = 2.5\n\n[force]")),
    ("argon for a few bodies", ("[force]", '[argon]\nsigma = "3.405 angstrom"\n\n[force]')),
    ("analysis of a fluid", ("[output]", "[analysis]\nrdf = {}\n\n[output]")),
]

SENSE = [
    ("three components in two dimensions", ("position = [2.0, 0.0]", "position = [2.0, 0.0, 0.0]")),
    ("velocity of one component", ("velocity = [0.0, -0.5]", "velocity = [-0.5]")),
    ("bodies in one place", ("position = [2.0, 0.0]", "position = [-1.0, 0.0]")),
    ("body in the central mass", ("softening = 0.0", "central_mass = 1.0"), ("position = [2.0, 0.0]", "position = [0.0, 0.0]")),
    ("orbit of a body that is not there", ("[output]", "[analysis]\norbit = { body = 3 }\n\n[output]")),
    ("orbit about a body that is not there", ("[output]", "[analysis]\norbit = { body = 1, about = 3 }\n\n[output]")),
    ("orbit of body zero", ("[output]", "[analysis]\norbit = { body = 0 }\n\n[output]")),
    ("orbit about itself", ("[output]", "[analysis]\norbit = { body = 1, about = 1 }\n\n[output]")),
    ("oscillation of a component that is not there",
     ("[output]", "[analysis]\noscillation = { component = 3 }\n\n[output]")),
    ("closest approach of one body", (BODY, ""), ("[output]", "[analysis]\nclosest_approach = {}\n\n[output]")),
    ("accelerations in H5MD",
     ("[output]", '[output]\ntrajectory = { every = 1, format = "h5md", accelerations = true }')),
    ("empty output directory of a few bodies", ("[output]", '[output]\ndirectory = ""')),
    ("two stages of one name", ("[output]", STAGE + "[output]")),
    ("sampled on the way back",
     ("[output]", STAGE.replace('"orbits"', '"back"\nreverse = true') + "[analysis]\nclosest_approach = {}\n\n[output]")),
    ("sampled with a gap",
     ("[output]", STAGE.replace('"orbits"', '"pause"\nsample = false') + STAGE.replace('"orbits"', '"again"') +
      "[analysis]\nclosest_approach = {}\n\n[output]")),
]

LINE = """\
[force]
type = "pendulum"
gravity = 1.0
length = 1.0

[[body]]
mass = 1.0
position = [0.5]
velocity = [0.0]

[[stage]]
name = "swing"
time_step = 0.01
steps = 10
"""
RADIAL = ('type = "pendulum"\ngravity = 1.0\nlength = 1.0',
          'type = "radial-kepler"\ngravitational_parameter = 1.0\nangular_momentum = 1.2')

ONE_COORDINATE = [
    ("pendulum of two components", ("position = [0.5]\nvelocity = [0.0]", "position = [0.5, 0.0]\nvelocity = [0.0, 0.0]")),
    ("pendulum without a length", ("length = 1.0", "length = 0.0")),
    ("radial motion at the centre", RADIAL, ("position = [0.5]", "position = [0.0]")),
    ("radial motion at a negative distance", RADIAL, ("position = [0.5]", "position = [-0.5]")),
    ("orbit of a distance about a body", RADIAL, ("steps = 10", "steps = 10\n\n[analysis]\norbit = { body = 1, about = 1 }")),
]

SETTINGS = [
    ("--set of a body that is not there", ["body.3.mass=1"]),
    ("--set of body zero", ["body.0.mass=1"]),
    ("--set of a mass below zero", ["body.2.mass=-1"]),
    ("--set of a position with a letter in it", ["body.2.position=[1, a]"]),
    ("--set of bodies into one place", ["body.2.position=[-1, 0]"]),
]


def many_at_once(t):
    t.deck(("mass = 3.0", "mass = -3.0"), ("velocity = [0.0, -0.5]", "velocity = []"), ("softening = 0.0", "softness = 0.1"),
           ("steps = 100", "steps = 1e2"), ("[output]", "[analysis]\norbit = {}\n\n[output]"), text=STARS)
    result = t.expect(2, t.run("run", "deck.toml"))
    found = [tuple(map(int, m)) for m in re.findall(r"^error: deck\.toml:(\d+):(\d+): ", result.err, flags=re.M)]
    t.equal(len(found), 5, "mistakes reported")
    t.equal(found, sorted(found), "order of the mistakes")
    t.golden(result.err)


def cases():
    result = [Case(name, refused((STARS, *edits))) for name, *edits in VALUES + STRUCTURE + SENSE]
    result += [Case(name, refused((LINE, *edits))) for name, *edits in ONE_COORDINATE]
    result += [Case(name, refused((STARS,), *[part for s in settings for part in ("--set", s)]))
               for name, settings in SETTINGS]
    return result + [Case("many mistakes of a few-body deck at once", many_at_once)]
