#include <catch2/catch.hpp>
#include <utility>

#include "compare/judge/small_problem.hpp"
#include "ljmd/compare/judge/frame_judgement.hpp"
#include "ljmd/compare/judge/near_pairs.hpp"
#include "ljmd/compare/judge/own_run.hpp"
#include "ljmd/compare/judge/point_judgement.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

constexpr double dt = 0.004;

/// The trajectory of an engine that does everything right: frames of ljmd's own.
JudgedTrajectory right_trajectory(const Fluid& fluid, const std::vector<Index>& steps) {
    JudgedTrajectory trajectory{fluid.edges, dt, {}};
    for (const Index step : steps) {
        trajectory.frames.push_back({.step = step, .positions = fluid.positions});
    }
    follow(fluid, *MadePeer::force_field_of(fluid), {}, trajectory);
    for (JudgedFrame& frame : trajectory.frames) {
        frame.positions = frame.our_positions;
        frame.velocities = frame.our_velocities;
        frame.forces = frame.our_forces;
    }
    return trajectory;
}

/// What is said, once ljmd's forces at the engine's positions are known.
std::vector<std::string> said(const Fluid& fluid, JudgedTrajectory trajectory) {
    follow(fluid, *MadePeer::force_field_of(fluid), {}, trajectory);
    return diagnose_trajectory(trajectory, fluid.potential, engine_agreement({}));
}

std::vector<Vec3> moved(std::vector<Vec3> a, double factor, const std::vector<Vec3>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] += factor * b[i];
    }
    return a;
}

}  // namespace

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

TEST_CASE("a start whose velocities were taken for those of another time is named, and another time step") {
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

TEST_CASE("pairs that a stale list has lost are found, by their earlier distance or one by one") {
    Fluid fluid = shaken_crystal();
    for (Vec3& v : fluid.velocities) {
        v *= 3.0;
    }
    // One frame in which few pairs have come in since the list was built, and one with more.
    for (const Index late : {20, 60}) {
        JudgedTrajectory trajectory = right_trajectory(fluid, {0, late});
        const std::vector<Vec3> listed = trajectory.frames[0].positions;
        JudgedFrame& frame = trajectory.frames[1];
        const double range = fluid.potential.cutoff().radius;
        const NearPairs now(frame.positions, fluid.edges, range);
        Index missing = 0;
        for (const NearPairs::Pair& pair : now.pairs()) {
            const Vec3 apart = listed[pair.i] - listed[pair.j];
            const Vec3 images = (apart.array() / fluid.edges.array()).round();
            if ((apart - images.cwiseProduct(fluid.edges)).norm() > range + 0.05) {
                const Vec3 force = fluid.potential(pair.distance).w * pair.separation;
                frame.forces[pair.i] -= force;
                frame.forces[pair.j] += force;
                ++missing;
            }
        }
        REQUIRE(missing > 0);
        const auto found = said(fluid, trajectory);
        REQUIRE(found.size() == 1);
        CHECK_THAT(found[0], StartsWith("stale list: forces are right at step 0") &&
                                 Catch::Contains("those of " + std::to_string(missing) + " pair"));
    }
    // A pair that any list would have had.
    JudgedTrajectory trajectory = right_trajectory(fluid, {0, 10});
    JudgedFrame& frame = trajectory.frames[1];
    const NearPairs::Pair pair = NearPairs(frame.positions, fluid.edges, 1.2).pairs().front();
    const Vec3 force = fluid.potential(pair.distance).w * pair.separation;
    frame.forces[pair.i] -= force;
    frame.forces[pair.j] += force;
    CHECK_THAT(said(fluid, trajectory).at(0), StartsWith("stale list: ") && Catch::Contains("those of 1 pair within"));
    // Forces of other positions altogether.
    frame.forces = trajectory.frames[0].forces;
    CHECK_THAT(said(fluid, trajectory).at(0), StartsWith("stale list or state"));
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
