#pragma once

#include "ljmd/engine/choices.hpp"
#include "ljmd/engine/fluid_spec.hpp"

namespace ljmd::test {

/// What small_deck says (deck/sample_decks.hpp), without a deck.
inline FluidSpec small_spec() {
    FluidSpec spec{.start = LatticeStart{.lattice = Lattice::fcc, .cells = 3},
                   .density = 0.8,
                   .temperature = 1.0,
                   .seed = 7,
                   .potential = PairPotential::lennard_jones("force-shifted", {.radius = 2.0, .switch_start = 0.0})};
    spec.stages = {
        {.name = "equilibrate",
         .time_step = 0.004,
         .steps = 20,
         .temperature = 1.0,
         .thermostat = thermostat("rescale", {{"every", 5}}),
         .seed = 7},
        {.name = "production", .time_step = 0.004, .steps = 40, .temperature = 1.0, .sample = true, .seed = 7}};
    return spec;
}

}  // namespace ljmd::test
