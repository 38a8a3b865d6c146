// A run of a fluid under a force of the calling program: energies, momentum, checkpoints, and what it does not go with.
#include <cmath>
#include <stdexcept>
#include "catch.hpp"

#include "engine/engine_fixtures.hpp"
#include "engine/fluid_system.hpp"
#include "engine/mistakes/mistakes.hpp"
#include "execution/test_execution.hpp"
#include "forces/made_external_force.hpp"
#include "integrators/integrator.hpp"
#include "ljmd/core/errors.hpp"
#include "model/velocities.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

FluidSpec spec_with(std::shared_ptr<ExternalForce> force) {
    FluidSpec spec = with_analyses();
    spec.external = std::move(force);
    return spec;
}

/// One stage of 60 steps, sampled at every step.
FluidSpec one_stage(std::shared_ptr<ExternalForce> force, const std::string& integrator_name = "velocity-verlet") {
    FluidSpec spec = small_spec();
    spec.external = std::move(force);
    spec.stages = {{.name = "only",
                    .integrator = integrator(integrator_name),
                    .time_step = 0.004,
                    .steps = 60,
                    .temperature = 1.0,
                    .sample = true}};
    spec.sample_every = 1;
    return spec;
}

FluidSpec with_thermostat(FluidSpec spec, const std::string& name) {
    spec.stages.front().thermostat = name == "rescale" ? thermostat(name, {{"every", 7}}) : thermostat(name);
    return spec;
}

}  // namespace

TEST_CASE("the external energy is a column of its own, part of the total energy, which is conserved with it") {
    Simulation simulation(one_stage(wave(3.0)));
    const RunResult result = simulation.run();
    double lowest = 1e9;
    double highest = -1e9;
    for (const ThermoRow& row : simulation.samples()) {
        const double external = row.values.external_energy.value();
        CHECK(row.values.total_energy ==
              Approx(row.values.potential_energy + row.values.kinetic_energy + external).epsilon(1e-14));
        lowest = std::min(lowest, external);
        highest = std::max(highest, external);
    }
    CHECK(highest - lowest > 0.05);
    CHECK(std::abs(simulation.samples().back().values.total_energy - simulation.samples().front().values.total_energy) <
          0.005 * (highest - lowest));
    CHECK(result.observable("external_energy").unit == "epsilon");
    CHECK(result.observable("total_energy").estimate->mean ==
          Approx(result.observable("potential_energy").estimate->mean +
                 result.observable("kinetic_energy").estimate->mean +
                 result.observable("external_energy").estimate->mean));
    CHECK_THROWS_AS(Simulation(one_stage(nullptr)).run().observable("external_energy"), InputError);
    CHECK_THROWS_AS(result.observable("heat_capacity_cv"), InputError);  // not that of a homogeneous fluid
}

TEST_CASE("energies between the samples have the external force, too") {
    FluidSpec rarely = one_stage(trap(0.5));
    rarely.sample_every = 50;
    Simulation simulation(rarely);
    Simulation sampled(one_stage(trap(0.5)));
    simulation.advance(7);
    sampled.advance(7);
    const Thermodynamics now = simulation.thermodynamics();
    const Thermodynamics& expected = sampled.samples().back().values;
    CHECK(*now.external_energy == Approx(*expected.external_energy).epsilon(1e-12));
    CHECK(now.total_energy == Approx(expected.total_energy).epsilon(1e-12));
    CHECK(*now.pressure == Approx(*expected.pressure).epsilon(1e-9));
}

TEST_CASE("a force without an energy does work: no energy is conserved, and none is watched") {
    FluidSpec driven = one_stage(uniform(Vec3(200.0, 0.0, 0.0)));
    driven.stages.front().steps = 30;
    Simulation simulation(driven);
    const RunResult result = simulation.run();
    CHECK(result.last.kinetic_energy > result.first.kinetic_energy + 100.0);
    CHECK_FALSE(result.stages.front().energy_drift.has_value());
    CHECK_FALSE(simulation.samples().back().conserved_energy.has_value());
    CHECK_THROWS_AS(result.observable("external_energy"), InputError);
}

TEST_CASE("a uniform force accelerates the centre of mass, and the temperature is that of the motion about it") {
    const Vec3 force(2.0, -1.0, 0.5);
    Simulation falling(one_stage(uniform(force)));
    Simulation resting(one_stage(nullptr));
    falling.run();
    resting.run();
    const double time = falling.state().time;
    CHECK((centre_velocity(falling.state()) - time * force).norm() < 1e-10);
    REQUIRE(falling.samples().size() == resting.samples().size());
    for (std::size_t k = 0; k < falling.samples().size(); ++k) {
        CHECK(*falling.samples()[k].values.temperature ==
              Approx(*resting.samples()[k].values.temperature).epsilon(1e-6));
        CHECK(*falling.samples()[k].values.pressure == Approx(*resting.samples()[k].values.pressure).epsilon(1e-5));
    }
}

TEST_CASE("thermostats that conserve momentum leave the centre of mass its fall, and hold the temperature about it") {
    const Vec3 force(40.0, 0.0, 0.0);
    for (const char* name : {"stochastic-rescaling", "nose-hoover-chain"}) {
        CAPTURE(name);
        Simulation falling(with_thermostat(one_stage(uniform(force)), name));
        Simulation resting(with_thermostat(one_stage(nullptr), name));
        falling.run();
        resting.run();
        CHECK((centre_velocity(falling.state()) - falling.state().time * force).norm() < 1e-9);
        CHECK(*falling.samples().back().values.temperature ==
              Approx(*resting.samples().back().values.temperature).epsilon(1e-5));
    }
    Simulation rescaled(with_thermostat(one_stage(uniform(force)), "rescale"));
    rescaled.advance(56);
    CHECK(*rescaled.samples().back().values.temperature == Approx(1.0).epsilon(1e-9));
}

TEST_CASE("heat is counted under an external force: what is conserved is total energy minus heat") {
    for (const char* name : {"stochastic-rescaling", "nose-hoover-chain", "langevin", "andersen"}) {
        CAPTURE(name);
        Simulation simulation(with_thermostat(one_stage(wave(3.0)), name));
        simulation.run();
        const double first = simulation.samples().front().values.total_energy;
        for (const ThermoRow& row : simulation.samples()) {
            if (row.step > 0) {
                CHECK(std::abs(row.conserved_energy.value() - first) < 2e-3);
            }
        }
        CHECK(std::abs(simulation.samples().back().values.total_energy - first) > 5e-3);
    }
}

TEST_CASE("the centre of mass is not stopped between stages, nor at a start with velocities") {
    FluidSpec spec = with_thermostat(one_stage(wave(1.0)), "langevin");
    spec.stages.push_back({.name = "free", .time_step = 0.004, .steps = 1, .sample = true});
    Simulation simulation(spec);
    simulation.advance(60);
    const Vec3 before = centre_velocity(simulation.state());
    simulation.run();
    CHECK(before.norm() > 0.01);
    CHECK((centre_velocity(simulation.state()) - before).norm() < 0.01 * before.norm() + 0.01);

    Configuration start{.edges = Vec3::Constant(6.0), .positions = {{1.0, 1.0, 1.0}, {3.0, 3.0, 3.0}}};
    start.velocities = {{1.0, 0.0, 0.0}, {0.0, 0.5, 0.0}};
    FluidSpec given = small_spec();
    given.start = start;
    given.external = wave(1.0);
    CHECK(centre_velocity(Simulation(given).state()) == Vec3(0.5, 0.25, 0.0));
    given.external = nullptr;
    CHECK(centre_velocity(Simulation(given).state()).norm() < 1e-15);
}

TEST_CASE("a random start is relaxed by the pair forces alone") {
    FluidSpec spec = one_stage(uniform(Vec3(1e4, 0.0, 0.0)));
    spec.start = RandomStart{.atoms = 108};
    FluidSpec without = spec;
    without.external = nullptr;
    CHECK(Simulation(spec).state().positions() == Simulation(without).state().positions());
}

TEST_CASE("a run under an external force is resumed with the same bits at any step, with every integrator") {
    for (const IntegratorMethod& method : all_integrators()) {
        if (method.unbounded_only) {
            continue;
        }
        CAPTURE(method.name);
        const auto spec = [&] {
            FluidSpec spec = one_stage(wave(2.0), method.name);
            spec.stages.front().steps = 30;
            return spec;
        };
        Simulation whole(spec());
        whole.run();
        Simulation parts(spec());
        for (const Index until : {1, 8, 19}) {
            parts.advance(until - parts.state().step);
            Simulation next(spec());
            next.restore(parts.checkpoint());
            parts = std::move(next);
        }
        parts.run();
        check_same(parts, whole);
    }
}

TEST_CASE("threads change no bit of a run under an external force") {
    Simulation one(spec_with(trap(1.0)), Execution({.threads = 1}));
    Simulation two(spec_with(trap(1.0)), Execution({.threads = 2}));
    one.run();
    two.run();
    check_same(one, two);
}

TEST_CASE("bit-reversible returns to its start under an external force") {
    FluidSpec spec = one_stage(trap(1.0), "bit-reversible");
    spec.stages.push_back(spec.stages.front());
    spec.stages.back().name = "back";
    spec.stages.back().reverse = true;
    spec.stages.back().sample = false;
    Simulation simulation(spec);
    const std::string start = checksum(simulation.state());
    simulation.advance(60);
    CHECK(checksum(simulation.state()) != start);
    simulation.run();
    CHECK(checksum(simulation.state()) == start);
}

TEST_CASE("a uniform force leaves diffusion as it is, and one that differs between atoms leaves it no value") {
    const auto moving = [](std::shared_ptr<ExternalForce> force) {
        FluidSpec spec = one_stage(std::move(force));
        spec.analyses = {analysis("msd", {{"max_time", 0.08}, {"every", 1}}),
                         analysis("vacf", {{"max_time", 0.04}, {"every", 1}})};
        return spec;
    };
    const RunResult resting = Simulation(moving(nullptr)).run();
    const RunResult falling = Simulation(moving(uniform(Vec3(20.0, -10.0, 5.0)))).run();
    Simulation shaken(moving(wave(2.0)));
    const RunResult in_wave = shaken.run();
    for (const char* name : {"diffusion", "diffusion_green_kubo"}) {
        CAPTURE(name);
        const double expected = resting.observable(name).estimate.value().mean;
        CHECK(falling.observable(name).estimate.value().mean == Approx(expected).epsilon(1e-5));
        CHECK_FALSE(in_wave.observable(name).estimate.has_value());
        CHECK_THAT(in_wave.observable(name).remark, Contains("the external force 'wave' differs between atoms"));
    }
    // What was seen before counts when a run goes on, too.
    const auto ends = std::make_shared<MadeForce>(
        [](const AtomPositions& atoms, Eigen::Matrix3Xd& forces) -> ExternalEnergy {
            forces.row(0).setConstant(1.0);
            forces(0, 0) = atoms.time() < 0.1 ? 2.0 : 1.0;
            return {};
        },
        false, false, "ends");
    Simulation first(moving(ends));
    first.advance(30);
    Simulation second(moving(ends));
    second.restore(first.checkpoint());
    CHECK_FALSE(second.run().observable("diffusion").estimate.has_value());
}

TEST_CASE("a checkpoint is continued with the external force that it had, and with no other") {
    Simulation simulation(spec_with(wave(1.0)));
    simulation.advance(30);
    const std::string checkpoint = simulation.checkpoint();
    CHECK_THROWS_AS(Simulation(spec_with(nullptr)).restore(checkpoint), CheckpointError);
    CHECK_THROWS_AS(Simulation(spec_with(wave(1.0, "other"))).restore(checkpoint), CheckpointError);
    CHECK_NOTHROW(Simulation(spec_with(wave(1.0))).restore(checkpoint));
}

TEST_CASE("what an external force throws ends the run") {
    struct Enough : std::runtime_error {
        Enough() : std::runtime_error("enough") {}
    };
    const auto force = std::make_shared<MadeForce>([](const AtomPositions& atoms, Eigen::Matrix3Xd&) {
        if (atoms.time() > 0.05) {
            throw Enough();
        }
        return ExternalEnergy{};
    });
    Simulation simulation(spec_with(force));
    CHECK_THROWS_AS(simulation.run(), Enough);
    CHECK(simulation.state().step > 5);
    CHECK(simulation.state().velocities().allFinite());
    CHECK_THROWS_AS(simulation.run(), InputError);
}

TEST_CASE("a barostat needs the virial, and analyses of pair forces need a fluid without external force") {
    FluidSpec spec = with_thermostat(one_stage(uniform(Vec3::UnitX())), "stochastic-rescaling");
    spec.stages.front().barostat = barostat("stochastic-cell-rescaling", {{"pressure", 1.0}});
    CHECK_THROWS_WITH(Simulation(spec),
                      Contains("stage 'only': a barostat needs the virial of the external force 'uniform'"));
    spec.external = wave(1.0);
    Simulation simulation(spec);
    simulation.run();
    CHECK(simulation.state().box().volume() != box_of(spec).volume());

    FluidSpec measured = one_stage(wave(1.0));
    measured.analyses = {analysis("viscosity"), analysis("chemical_potential"), analysis("rdf")};
    const std::vector<Mistake> found = external_force_mistakes(measured);
    REQUIRE(found.size() == 2);
    CHECK_THAT(in_words(found.front()), Contains("analysis viscosity: it is for a homogeneous fluid"));
    measured.external = wave(1.0, "");
    CHECK_THROWS_WITH(Simulation(measured), Contains("its name must be"));
}

TEST_CASE("an external force is called once an evaluation, in order of time, at the times of the positions") {
    for (const IntegratorMethod& method : all_integrators()) {
        if (method.unbounded_only) {
            continue;
        }
        CAPTURE(method.name);
        const std::shared_ptr<MadeForce> force = wave(1.0);
        FluidSpec spec = one_stage(force, method.name);
        Simulation simulation(spec);
        simulation.advance(0);
        for (Index n = 1; n <= 4; ++n) {
            const std::size_t before = force->times.size();
            simulation.advance(1);
            REQUIRE(force->times.size() > before);
            CHECK(force->times.back() == Approx(0.004 * static_cast<double>(n)).epsilon(1e-12));
            if (method.name == "drift-kick-drift" || method.name == "rk2-midpoint") {
                CHECK(force->times[force->times.size() - 2] ==
                      Approx(0.004 * (static_cast<double>(n) - 0.5)).epsilon(1e-12));
            }
        }
        CHECK(simulation.state().time == 0.016);
    }
}
