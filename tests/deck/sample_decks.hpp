#pragma once

#include <string>

namespace ljmd::test {

/// 108 atoms, two stages, one of them sampled: right in every respect, and done in a few milliseconds.
inline const std::string small_deck = R"(title = "A small liquid"

[system]
lattice = { type = "fcc", cells = 3 }
density = 0.8
temperature = 1.0
seed = 7

[potential]
type = "lennard-jones"
cutoff = 2.0
truncation = "force-shifted"

[[stage]]
name = "equilibrate"
time_step = 0.004
steps = 20
thermostat = { type = "rescale", every = 5 }

[[stage]]
name = "production"
time_step = 0.004
steps = 40
sample = true
)";

/// Two stars of mass 0.5 on an ellipse about each other, a = 1/1.64, e = 0.64, beginning at apocentre 1.
inline const std::string stars_deck = R"(title = "Two stars"

[force]
type = "newtonian-gravity"
gravitational_constant = 1.0

[[body]]
mass = 0.5
position = [-0.5, 0.0]
velocity = [0.0, -0.3]

[[body]]
mass = 0.5
position = [0.5, 0.0]
velocity = [0.0, 0.3]

[[stage]]
name = "orbits"
time_step = 0.01
steps = 95

[output]
thermo = { every = 10 }
)";

/// A comet by its distance alone, beginning at pericentre.
inline const std::string radial_deck = R"(title = "A distance"

[force]
type = "radial-kepler"
gravitational_parameter = 1.0
angular_momentum = 1.2

[[body]]
mass = 2.0
position = [1.0]
velocity = [0.0]

[[stage]]
name = "out"
time_step = 0.01
steps = 50
)";

}  // namespace ljmd::test
