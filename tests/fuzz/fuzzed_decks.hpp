#pragma once

#include <string>
#include <vector>

#include "deck/sample_decks.hpp"

/// Decks whose checkpoints are tried: runs of a millisecond that have a bit of everything in their state.
namespace ljmd::fuzz {

struct FuzzedDeck {
    std::string text;
    std::vector<std::string> settings;
};

inline const FuzzedDeck fluid{
    test::small_deck + R"(
[output]
trajectory = { format = "xyz", every = 2, velocities = true }
checkpoint = { every = 3 }

[analysis]
rdf = { bins = 2, every = 1 }
structure_factor = { k_max = 2.0, width = 1.0, every = 2 }
msd = { every = 1, origins = 2 }
vacf = { every = 1 }
viscosity = { every = 1 }
bulk_viscosity = { every = 1 }
thermal_conductivity = { every = 1 }
chemical_potential = { every = 2, insertions = 2 }
film = { every = 2, layers = 4 }
crystal = { every = 2, families = 2 }
response_functions = { every = 2 }
configurational_temperature = { every = 2 }
cutoff_correction = { every = 2 }
)",
    {"system.lattice.cells=1", "system.density=0.1", "potential.cutoff=1.5", "neighbors.skin=0.15",
     "output.thermo.every=1", "stage.equilibrate.steps=4", "stage.equilibrate.thermostat.every=2",
     "stage.production.steps=6", "stage.production.integrator=position-verlet"}};

/// A box that changes under a thermostat with numbers of its own.
inline const FuzzedDeck constant_pressure{
    test::small_deck + R"(
thermostat = { type = "nose-hoover-chain" }
barostat = { type = "stochastic-cell-rescaling", pressure = 0.1, every = 2 }

[output]
checkpoint = { every = 3 }
)",
    {"system.lattice.type=simple-cubic", "system.lattice.cells=2", "system.density=0.1", "potential.cutoff=1.5",
     "output.thermo.every=1", "stage.equilibrate.steps=4", "stage.production.steps=6"}};

/// There and back.
inline const FuzzedDeck orbit{test::stars_deck + R"(
trajectory = { format = "csv", every = 2 }
checkpoint = { every = 4 }

[[stage]]
name = "back"
time_step = 0.3
steps = 3
sample = false
reverse = true

[analysis]
orbit = { body = 1, about = 2 }
closest_approach = {}
)",
                              {"output.thermo.every=1", "stage.orbits.time_step=0.3", "stage.orbits.steps=8"}};

/// A comet by its distance alone: its angle is integrated beside it.
inline const FuzzedDeck radial{test::radial_deck + R"(
[output]
checkpoint = { every = 4 }

[analysis]
orbit = { body = 1 }
oscillation = { body = 1 }
)",
                               {"stage.out.time_step=0.3", "stage.out.steps=10"}};

}  // namespace ljmd::fuzz
