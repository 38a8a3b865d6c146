// A stage that begins at a given total energy.
#include "ljmd/detail/engine/energy_start.hpp"

#include <cmath>
#include "catch.hpp"

#include "engine/engine_fixtures.hpp"
#include "engine/mistakes/mistakes.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/engine/requested_temperature.hpp"
#include "model/velocities.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

/// A thermostat, then a stage at this energy, sampled at every step.
FluidSpec spec_at(double total_energy) {
    FluidSpec spec = small_spec();
    spec.potential = PairPotential::lennard_jones("cut", {2.0, 0.0});
    spec.tail = true;
    spec.sample_every = 1;
    spec.stages = {{.name = "equilibrate",
                    .time_step = 0.004,
                    .steps = 20,
                    .temperature = 1.0,
                    .thermostat = thermostat("andersen")},
                   {.name = "measure",
                    .integrator = integrator("leapfrog"),
                    .time_step = 1e-7,
                    .steps = 3,
                    .sample = true,
                    .total_energy = total_energy}};
    return spec;
}

}  // namespace

TEST_CASE("a stage begins at the total energy that was asked for, tail included, with its centre of mass at rest") {
    Simulation simulation(spec_at(-3.25));
    const RunResult result = simulation.run();
    // After a step of 1e-7 tau the energy is still that of the start.
    CHECK(std::abs(simulation.samples().at(21).values.total_energy + 3.25) < 1e-12);
    const StageResult& stage = result.stages.at(1);
    REQUIRE(stage.energy_start.has_value());
    CHECK_FALSE(result.stages.at(0).energy_start.has_value());
    const Thermodynamics& before = simulation.samples().at(20).values;
    CHECK(stage.energy_start->total_energy == -3.25);
    CHECK(stage.energy_start->potential_energy == Approx(before.potential_energy).epsilon(1e-12));
    CHECK(stage.energy_start->velocity_factor ==
          Approx(std::sqrt((-3.25 - stage.energy_start->potential_energy) / stage.energy_start->kinetic_before)));
    CHECK(total_momentum(simulation.state()).norm() < 1e-11);
}

TEST_CASE("who asks for a total energy asks for no temperature") {
    FluidSpec spec = spec_at(-3.25);
    CHECK_FALSE(requested_temperature(spec).has_value());
    spec.stages[1].total_energy.reset();
    CHECK(requested_temperature(spec) == std::optional<double>(1.0));
}

TEST_CASE("an energy below the potential energy, and atoms at rest, are refused") {
    Simulation too_low(spec_at(-20.0));
    CHECK_THROWS_WITH(too_low.run(), Contains("step 20") && Contains("(stage 'measure'): total_energy is -20 ") &&
                                         Contains("potential energy of -"));
    State state(2, Box(Vec3::Constant(5.0)));
    Thermodynamics at_rest;
    at_rest.total_energy = -1.0;
    CHECK_THROWS_WITH(scale_to_total_energy(state, at_rest, 1.0), Contains("at rest"));
}

TEST_CASE("a total energy goes with no thermostat, and must be a number") {
    FluidSpec spec = spec_at(-3.0);
    CHECK(mistakes(spec).empty());
    spec.stages[1].total_energy = std::nan("");
    CHECK_THAT(mistakes(spec).at(0), Contains("stage 'measure': total_energy must be a finite number"));
    spec.stages[1].total_energy = -3.0;
    spec.stages[1].thermostat = thermostat("langevin");
    spec.stages[1].integrator = integrator("velocity-verlet");
    spec.stages[1].temperature = 1.0;
    CHECK_THAT(mistakes(spec).at(0), Contains("a thermostat would change it"));
}
