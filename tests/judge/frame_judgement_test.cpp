#include "judge/frame_judgement.hpp"

#include "catch.hpp"

#include "judge/point_judgement.hpp"

using namespace ljmd;

namespace {

/// One atom, as both see it.
JudgedFrame made_frame(Index step) {
    return {.step = step,
            .positions = {Vec3(5.5, 1, 1)},
            .velocities = {Vec3(1, 0, 0)},
            .forces = {Vec3(0, 2, 0)},
            .forces_there = {Vec3(0, 2, 0)},
            .our_positions = {Vec3(-0.5, 1, 13)},
            .our_velocities = {Vec3(1, 0, 0)},
            .our_forces = {Vec3(0, 2, 0)}};
}

const Vec3 edges(6, 6, 6);

}  // namespace

TEST_CASE("positions are compared by their nearest images") {
    JudgedFrame frame = made_frame(1);
    CHECK(largest_distance(frame, edges) == 0.0);
    frame.positions[0][1] += 0.25;
    CHECK(largest_distance(frame, edges) == 0.25);
    frame.positions[0][1] = std::numeric_limits<double>::quiet_NaN();
    CHECK(std::isnan(largest_distance(frame, edges)));
}

TEST_CASE("frames have checks of what they hold, at the steps that are judged") {
    JudgedTrajectory trajectory{edges, 0.004, {made_frame(0), made_frame(1), made_frame(150), made_frame(900)}};
    const Agreement agreement = engine_agreement({.temperature = 2.0});
    const auto names = [&](const std::vector<Index>& steps) {
        std::vector<std::string> all;
        for (const Check& check : check_trajectory(trajectory, steps, agreement)) {
            all.push_back(check.name);
            CHECK(check.passed());
        }
        return all;
    };
    CHECK(names({1}) == std::vector<std::string>{"step 1: positions", "step 1: velocities", "step 1: kinetic energy",
                                                 "step 1: forces at the engine's positions"});
    CHECK(names({150}) == std::vector<std::string>{"step 150: positions", "step 150: velocities",
                                                   "step 150: forces at the engine's positions"});
    CHECK(names({900}) == std::vector<std::string>{"step 900: forces at the engine's positions"});
    trajectory.frames[1].velocities.clear();
    trajectory.frames[1].forces.clear();
    CHECK(names({1}) == std::vector<std::string>{"step 1: positions"});
}

TEST_CASE("differences of frames fail their checks") {
    const Agreement agreement = engine_agreement({});
    JudgedTrajectory trajectory{edges, 0.004, {made_frame(1)}};
    trajectory.frames[0].positions[0][0] += 1e-6;
    trajectory.frames[0].velocities[0][0] += 1e-6;
    trajectory.frames[0].forces[0][0] += 1e-6;
    for (const Check& check : check_trajectory(trajectory, {1}, agreement)) {
        INFO(check.name);
        CHECK_FALSE(check.passed());
        CHECK(check.value == Approx(check.name == "step 1: forces at the engine's positions" ? 0.5e-6
                                    : check.name == "step 1: positions"                      ? 1e-6
                                    : check.name == "step 1: velocities"                     ? 1e-6
                                                                                             : 2e-6)
                                 .epsilon(1e-3));
    }
}

TEST_CASE("velocities that leave the kinetic energy as it is fail, and have no limit where positions have none") {
    const Agreement agreement = engine_agreement({});
    JudgedTrajectory trajectory{edges, 0.004, {made_frame(1), made_frame(10), made_frame(900)}};
    for (JudgedFrame& frame : trajectory.frames) {
        frame.velocities[0] = -frame.velocities[0];
    }
    std::vector<std::string> failed;
    for (const Check& check : check_trajectory(trajectory, {1, 10, 900}, agreement)) {
        if (!check.passed()) {
            failed.push_back(check.name);
            CHECK(check.value == Approx(2.0));
        }
    }
    CHECK(failed == std::vector<std::string>{"step 1: velocities", "step 10: velocities"});
    CHECK_FALSE(velocity_limit(agreement, 900, 0.004));
    // Velocities that are made of rounded positions are as coarse as the time step is short.
    CHECK(velocity_limit(agreement, 1, 1e-5).value() > 10.0 * velocity_limit(agreement, 1, 1e-3).value());
}
