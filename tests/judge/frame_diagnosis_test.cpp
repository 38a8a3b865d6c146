#include <utility>
#include "catch.hpp"

#include "judge/right_trajectory.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

TEST_CASE("a right trajectory has no diagnosis, whether its positions are wrapped or not") {
    const Fluid fluid = shaken_crystal();
    JudgedTrajectory trajectory = right_trajectory(fluid, {0, 1, 10});
    CHECK(said(fluid, trajectory).empty());
    for (JudgedFrame& frame : trajectory.frames) {
        for (Vec3& r : frame.positions) {
            r += Vec3(2.0 * fluid.edges[0], 0.0, -fluid.edges[2]);
        }
    }
    CHECK(said(fluid, trajectory).empty());
}

TEST_CASE("atoms in another order are named, and nothing that follows from it") {
    const Fluid fluid = shaken_crystal();
    JudgedTrajectory trajectory = right_trajectory(fluid, {0, 1, 10});
    for (JudgedFrame& frame : trajectory.frames) {
        std::swap(frame.positions[0], frame.positions[5]);
        std::swap(frame.forces[0], frame.forces[5]);
    }
    const auto words = said(fluid, trajectory);
    REQUIRE(words.size() == 1);
    CHECK_THAT(words.front(), StartsWith("another order: at step 0, 2 of "));
    // an atom that stands nowhere known is something else
    trajectory.frames[0].positions[0] += Vec3(0.3, 0.0, 0.0);
    for (const std::string& each : said(fluid, trajectory)) {
        CHECK_THAT(each, !StartsWith("another order"));
    }
}

TEST_CASE("wrong forces at the start are not called right because atoms collide later") {
    const Fluid fluid = shaken_crystal();
    JudgedTrajectory trajectory = right_trajectory(fluid, {0, 1});
    trajectory.frames[0].forces[0] += Vec3(0.5, 0.0, 0.0);
    trajectory.frames[1].positions[1] = trajectory.frames[1].positions[0] + Vec3(0.05, 0.0, 0.0);
    for (const std::string& each : said(fluid, trajectory)) {
        CHECK_THAT(each, !Contains("forces are right at step 0"));
    }
}

TEST_CASE("a field that is switched on after the start is no stale list") {
    const Fluid fluid = shaken_crystal();
    JudgedTrajectory trajectory = right_trajectory(fluid, {0, 1});
    for (Vec3& f : trajectory.frames[1].forces) {
        f += Vec3(0.0, 0.0, -0.01);
    }
    const auto words = said(fluid, trajectory);
    REQUIRE(words.size() == 1);
    CHECK_THAT(words[0], StartsWith("at step 1, constant force: the same force of -0.01 along z"));
}

TEST_CASE("velocities of half a step before or after are named") {
    const Fluid fluid = shaken_crystal();
    const JudgedTrajectory right = right_trajectory(fluid, {0, 1, 10});
    for (const auto& [side, words] : {std::pair(-0.5, "earlier"), std::pair(0.5, "later")}) {
        JudgedTrajectory trajectory = right;
        for (JudgedFrame& frame : trajectory.frames) {
            frame.velocities = moved(frame.velocities, side * dt, frame.our_forces);
        }
        const auto found = said(fluid, trajectory);
        REQUIRE(found.size() == 1);
        CHECK_THAT(found[0], StartsWith("half-step velocities") && Catch::Contains(words));
    }
}

TEST_CASE("right forces at wrong places are a matter of the integration, wrong ones at the start are not") {
    const Fluid fluid = shaken_crystal();
    JudgedTrajectory trajectory = right_trajectory(fluid, {0, 10});
    JudgedFrame& frame = trajectory.frames[1];
    for (std::size_t i = 0; i < frame.positions.size(); i += 2) {
        frame.positions[i] += Vec3(1e-5, 0.0, 0.0);
    }
    follow(fluid, *MadePeer::force_field_of(fluid), {}, trajectory);
    frame.forces = frame.forces_there;
    CHECK_THAT(said(fluid, trajectory).at(0), StartsWith("integration: at step 10"));
    trajectory.frames[0].forces[3] += Vec3(0.1, 0.0, 0.0);
    frame.forces[3] += Vec3(0.1, 0.0, 0.0);
    CHECK(said(fluid, trajectory).empty());
}
