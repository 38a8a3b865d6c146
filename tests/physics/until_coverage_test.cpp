// How often the interval mean +- error of a run that has ended at an error covers the truth.
#include <cmath>
#include <vector>
#include "catch.hpp"

#include "ljmd/ljmd.hpp"

using namespace ljmd;

namespace {

/// 32 atoms of a dense gas under friction and noise, whose energies are correlated over about ten samples.
FluidSpec gas(std::uint64_t seed, Index steps) {
    FluidSpec spec{.start = LatticeStart{.lattice = Lattice::fcc, .cells = 2},
                   .density = 0.3,
                   .temperature = 2.0,
                   .seed = seed,
                   .potential = PairPotential::lennard_jones("force-shifted", {.radius = 2.0, .switch_start = 0.0})};
    const auto noise = thermostat("langevin", {{"time", 0.2}});
    spec.sample_every = 10;
    spec.stages = {{.name = "equilibrate", .time_step = 0.005, .steps = 1000, .temperature = 2.0, .thermostat = noise},
                   {.name = "production",
                    .time_step = 0.005,
                    .steps = steps,
                    .temperature = 2.0,
                    .sample = true,
                    .thermostat = noise}};
    return spec;
}

}  // namespace

TEST_CASE("of 400 short runs that end at an error 61 to 75 % cover the truth", "[long]") {
    const Execution execution;
    Simulation longest(gas(1, 4'000'000), execution);
    const double truth = longest.run().observable("potential_energy").estimate->mean;
    int inside = 0;
    int reached = 0;
    for (std::uint64_t seed = 2; seed < 402; ++seed) {
        FluidSpec spec = gas(seed, 1'000'000);
        spec.stages.back().until = {{"potential_energy", 0.012}};
        Simulation simulation(spec, execution);
        const RunResult result = simulation.run();
        const Estimate& found = result.observable("potential_energy").estimate.value();
        inside += std::abs(found.mean - truth) <= found.standard_error ? 1 : 0;
        reached += result.stages.back().until->reached ? 1 : 0;
    }
    INFO(inside << " of 400");
    CHECK(reached == 400);
    CHECK(inside >= 244);
    CHECK(inside <= 300);
}
