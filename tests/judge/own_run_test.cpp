#include "judge/own_run.hpp"

#include "catch.hpp"

#include "judge/point_judgement.hpp"
#include "judge/small_problem.hpp"

using namespace ljmd;
using namespace ljmd::test;

TEST_CASE("what ljmd says about frames is its own trajectory, and its forces where the engine's atoms are") {
    const Fluid fluid = shaken_crystal();
    JudgedTrajectory trajectory{fluid.edges, 0.004, {}};
    trajectory.frames.push_back({.step = 0, .positions = fluid.positions});
    trajectory.frames.push_back({.step = 5, .positions = fluid.positions});
    follow(fluid, *MadePeer::force_field_of(fluid), {}, trajectory);
    const PeerPoint point = point_of(fluid, *MadePeer::force_field_of(fluid));
    CHECK(trajectory.frames[0].our_positions == fluid.positions);
    CHECK(trajectory.frames[0].our_velocities == fluid.velocities);
    CHECK(trajectory.frames[0].our_forces == point.forces);
    CHECK(trajectory.frames[1].forces_there == point.forces);
    const auto frames = follow(fluid, *MadePeer::force_field_of(fluid), "velocity-verlet", 0.004, {0, 5});
    CHECK(trajectory.frames[1].our_positions == frames[1].positions);
}

TEST_CASE("our own run has a sample of the whole system every few steps, without the start") {
    const Problem problem = small_problem();
    const OwnSide own = own_side(problem);
    const RunSamples samples = own_run(problem, own.spec, own.execution);
    REQUIRE(samples.kinetic_energy.size() == 8);
    const PeerPoint start = point_of(problem.fluid, *MadePeer::force_field_of(problem.fluid));
    const double energy = start.totals.potential_energy + start.totals.kinetic_energy;
    for (std::size_t k = 0; k < 8; ++k) {
        CHECK(samples.potential_energy[k] + samples.kinetic_energy[k] == Approx(energy).epsilon(1e-4));
        CHECK(samples.volume[k] == problem.fluid.edges.prod());
    }
}

TEST_CASE("velocities of half a step earlier have another kinetic energy") {
    Fluid fluid = shaken_crystal();
    for (Vec3& v : fluid.velocities) {
        v = Vec3(1.0, 0.0, 0.0);
    }
    const std::vector<Vec3> forces(fluid.velocities.size(), Vec3(2.0, 0.0, 0.0));
    CHECK(half_step_kinetic_energy(fluid, forces, 0.0) == Approx(54.0));
    CHECK(half_step_kinetic_energy(fluid, forces, -0.25) == Approx(0.25 * 54.0));
}
