#pragma once

#include "catch.hpp"

#include "ljmd/engine/choices.hpp"
#include "ljmd/engine/fluid_spec.hpp"
#include "ljmd/engine/simulation.hpp"
#include "model/checksum.hpp"

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

inline FluidSpec with_analyses() {
    FluidSpec spec = small_spec();
    spec.analyses = {analysis("rdf", {{"every", 5}}), analysis("msd", {{"max_time", 0.08}, {"every", 1}})};
    return spec;
}

/// The same bits: state, observables, tables.
inline void check_same(const Simulation& a, const Simulation& b) {
    CHECK(a.state().step == b.state().step);
    CHECK(a.state().time == b.state().time);
    CHECK(checksum(a.state()) == checksum(b.state()));
    CHECK(a.state().velocities() == b.state().velocities());
    const RunResult ours = a.result();
    const RunResult theirs = b.result();
    REQUIRE(ours.averages.size() == theirs.averages.size());
    for (std::size_t k = 0; k < ours.averages.size(); ++k) {
        CHECK(ours.averages[k].name == theirs.averages[k].name);
        CHECK(ours.averages[k].estimate.has_value() == theirs.averages[k].estimate.has_value());
        if (ours.averages[k].estimate) {
            CHECK(ours.averages[k].estimate->mean == theirs.averages[k].estimate->mean);
        }
    }
    REQUIRE(ours.tables.size() == theirs.tables.size());
    for (std::size_t k = 0; k < ours.tables.size(); ++k) {
        CHECK(ours.tables[k].rows == theirs.tables[k].rows);
    }
}

}  // namespace ljmd::test
