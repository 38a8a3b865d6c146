#include <cmath>
#include "catch.hpp"

#include "judge/right_trajectory.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

TEST_CASE(
    "a start whose velocities were taken for those of another time, or another time step, is told by step 1 alone") {
    const Fluid fluid = shaken_crystal();
    JudgedTrajectory trajectory = right_trajectory(fluid, {0, 1});
    const JudgedFrame& start = trajectory.frames[0];
    JudgedFrame& frame = trajectory.frames[1];
    const std::vector<Vec3> right = frame.positions;
    frame.forces.clear();
    frame.positions = moved(right, 0.5 * dt * dt, start.our_forces);
    CHECK_THAT(said(fluid, trajectory).at(0), StartsWith("half-step start") && Catch::Contains("t = -dt/2"));
    frame.positions = moved(right, -0.5 * dt * dt, start.our_forces);
    CHECK_THAT(said(fluid, trajectory).at(0), StartsWith("half-step start") && Catch::Contains("t = +dt/2"));
    const double other = 0.005;
    frame.positions =
        moved(moved(start.our_positions, other, start.our_velocities), 0.5 * other * other, start.our_forces);
    CHECK_THAT(said(fluid, trajectory).at(0),
               StartsWith("another time step") && Catch::Contains("time step of 0.005 "));
}

TEST_CASE("another mass is told from a start half a step off by the velocities of step 1") {
    Fluid fluid = shaken_crystal();
    const double mass = 0.5;  // where the atoms are at step 1 as after such a start
    JudgedTrajectory trajectory = right_trajectory(fluid, {0, 1});
    JudgedFrame& frame = trajectory.frames[1];
    // F/m for dt is F for dt/m^(1/2), with velocities m^(1/2) v.
    JudgedTrajectory heavy{fluid.edges, dt / std::sqrt(mass), {{.step = 1, .positions = fluid.positions}}};
    for (Vec3& v : fluid.velocities) {
        v *= std::sqrt(mass);
    }
    follow(fluid, *MadePeer::force_field_of(fluid), {}, heavy);
    frame.positions = heavy.frames[0].our_positions;
    for (std::size_t i = 0; i < frame.velocities.size(); ++i) {
        frame.velocities[i] = heavy.frames[0].our_velocities[i] / std::sqrt(mass);
    }
    frame.forces = heavy.frames[0].our_forces;
    CHECK_THAT(said(shaken_crystal(), trajectory).at(0), StartsWith("mass: ") && Contains("if their mass is 0.5,"));
}

TEST_CASE("one atom that is elsewhere is named by its id, and by its mass") {
    const Fluid fluid = shaken_crystal();
    const JudgedTrajectory right = right_trajectory(fluid, {0, 1});
    JudgedTrajectory trajectory = right;
    trajectory.frames[1].forces.clear();
    trajectory.frames[1].positions[6] += 0.5 * dt * dt * (1.0 / 1.5 - 1.0) * right.frames[0].our_forces[6];
    CHECK_THAT(said(fluid, trajectory).at(0),
               StartsWith("one atom: at step 1 the one of id 7 alone") && Contains("if its mass is 1.5"));
    trajectory = right;
    trajectory.frames[0].positions[6] += Vec3(0.01, 0.0, 0.0);
    CHECK_THAT(said(fluid, trajectory).at(0),
               StartsWith("one atom: at step 0 the one of id 7 alone is elsewhere, by (0.01, "));
}

TEST_CASE("a start that was read with few digits is told from frames that have few") {
    const Fluid fluid = shaken_crystal();
    const JudgedTrajectory right = right_trajectory(fluid, {0, 1, 10});
    const auto to_six = [](double x) { return std::round(x * 1e6) / 1e6; };
    Fluid coarse = fluid;
    for (Vec3& r : coarse.positions) {
        r = r.unaryExpr(to_six);
    }
    JudgedTrajectory trajectory = right;
    const JudgedTrajectory moved_on = right_trajectory(coarse, {0, 1, 10});
    for (std::size_t k = 0; k < 3; ++k) {
        trajectory.frames[k].positions = moved_on.frames[k].positions;
    }
    trajectory.frames[0].positions = coarse.positions;
    CHECK(said(fluid, trajectory) ==
          std::vector<std::string>{
              "digits of the start: the positions of step 0 are those of start.xyz with 6 decimals"});
    trajectory = right;
    for (JudgedFrame& frame : trajectory.frames) {
        for (Vec3& r : frame.positions) {
            r = r.unaryExpr(to_six);
        }
    }
    CHECK_THAT(said(fluid, trajectory).at(0), StartsWith("few digits: positions of the frames have 6 decimals"));
    trajectory.frames[1].positions = moved(trajectory.frames[1].positions, 0.01 * dt, right.frames[0].our_velocities);
    for (Vec3& r : trajectory.frames[1].positions) {
        r = r.unaryExpr(to_six);
    }
    CHECK_THAT(said(fluid, trajectory).at(0), !StartsWith("few digits"));
}
