#pragma once

#include <string>

/// Decks whose checkpoints are tried: runs of a millisecond that have a bit of everything in their state.
namespace ljmd::fuzz {

inline const std::string fluid_deck = R"(
[system]
lattice = { type = "fcc", cells = 1 }
density = 0.1
temperature = 1.0
seed = 7

[potential]
type = "lennard-jones"
cutoff = 1.5
truncation = "force-shifted"

[neighbors]
skin = 0.15

[[stage]]
name = "equilibrate"
time_step = 0.004
steps = 4
thermostat = { type = "rescale", every = 2 }

[[stage]]
name = "production"
integrator = "position-verlet"
time_step = 0.004
steps = 6
sample = true

[output]
thermo = { every = 1 }
trajectory = { format = "xyz", every = 2, velocities = true }
checkpoint = { every = 3 }

[analysis]
rdf = { bins = 2, every = 1 }
)";

/// Two stars on an ellipse, and there and back.
inline const std::string orbit_deck = R"(
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
time_step = 0.3
steps = 8
sample = true

[[stage]]
name = "back"
time_step = 0.3
steps = 3
sample = false
reverse = true

[output]
trajectory = { format = "csv", every = 2 }
checkpoint = { every = 4 }

[analysis]
orbit = { body = 1, about = 2 }
closest_approach = {}
)";

/// A comet by its distance alone: its angle is integrated beside it.
inline const std::string radial_deck = R"(
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
time_step = 0.3
steps = 10
sample = true

[output]
checkpoint = { every = 4 }

[analysis]
orbit = { body = 1 }
oscillation = { body = 1 }
)";

}  // namespace ljmd::fuzz
