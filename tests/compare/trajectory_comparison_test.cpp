#include "compare/trajectory_comparison.hpp"

#include <cmath>
#include <limits>
#include "catch.hpp"

#include "compare/made_peer.hpp"
#include "forces/pair_force_field.hpp"

using namespace ljmd;
using namespace ljmd::test;

namespace {

TrajectoryComparison compared(MadePeer& peer, const std::vector<Index>& steps) {
    return compare_trajectories(
        peer.fluid, [&] { return MadePeer::force_field_of(peer.fluid); }, peer, 0.004, steps);
}

}  // namespace

TEST_CASE("frames of ljmd are unwrapped, by id, and carry the energies of their steps") {
    const Fluid fluid = warm_crystal();
    PairForceField verlet_list(fluid.potential, make_pair_search("verlet-list", 0.3));
    const auto frames = follow(fluid, verlet_list, "leapfrog", 0.004, {0, 3, 50});
    REQUIRE(frames.size() == 3);
    CHECK(frames[0].positions == fluid.positions);
    CHECK(frames[0].kinetic_energy == Approx(kinetic_energy(fluid)).epsilon(1e-14));
    State state = state_of(fluid);
    PairForceField all_pairs(fluid.potential, make_pair_search("all-pairs", 0.3));
    advance(state, all_pairs, 0.004, 50);
    const auto expected = unwrapped_by_id(state);
    for (std::size_t i = 0; i < fluid.positions.size(); ++i) {
        CHECK((frames[2].positions[i] - expected.col(static_cast<Index>(i))).norm() < 1e-11);
    }
    const double energy = all_pairs.evaluate(state, Request::forces_and_energy).potential_energy;
    CHECK(frames[2].potential_energy == Approx(energy).epsilon(1e-12));
    CHECK(frames[2].kinetic_energy == Approx(kinetic_energy(state)).epsilon(1e-12));
    CHECK(frames[0].potential_energy != frames[1].potential_energy);
}

TEST_CASE("every method of a peer is followed by those of ours that belong to it") {
    MadePeer peer(warm_crystal());
    const TrajectoryComparison comparison = compared(peer, {0, 1, 10});
    REQUIRE(comparison.pairings.size() == 3);
    CHECK(comparison.pairings[0].ours == "leapfrog");
    CHECK(comparison.pairings[1].ours == "velocity-verlet");
    CHECK_FALSE(comparison.pairings[1].same_order);
    CHECK(comparison.pairings[2].theirs == "two");
    CHECK(comparison.pairings[2].same_order);
    REQUIRE(comparison.rows.size() == 3);
    CHECK(comparison.rows[2].time == Approx(0.04));
    CHECK(comparison.rows[2].distances[1] == 0.0);
    CHECK(comparison.rows[2].distances[0] < 1e-13);
}

TEST_CASE("the atom that is furthest off tells the distance") {
    MadePeer peer(warm_crystal());
    peer.spoil = [](PeerFrame& frame) {
        frame.positions[7] += Vec3(0.0, 3e-3, 4e-3) * static_cast<double>(frame.step);
        frame.positions[8] += Vec3(1e-3, 0.0, 0.0);
        frame.kinetic_energy *= 1.0 + 1e-7;
        frame.potential_energy *= 1.0 - 1e-6;
    };
    const TrajectoryComparison comparison = compared(peer, {0, 2});
    CHECK(comparison.rows[1].distances[1] == Approx(1e-2));
    CHECK(comparison.rows[1].kinetic_difference == Approx(1e-7).epsilon(0.01));  // beside the start, which is larger
    CHECK(comparison.rows[1].potential_difference == Approx(1e-6).epsilon(1e-4));
}

TEST_CASE("frames are judged where it was asked for, within the limits") {
    MadePeer peer(warm_crystal());
    const Agreement agreement = double_agreement({});
    const TrajectoryComparison good = compared(peer, {0, 1, 5, 10});
    const auto checks = checks_of(good, {1, 10}, agreement);
    REQUIRE(checks.size() == 8);  // three pairings and the kinetic energy, twice
    for (const Check& check : checks) {
        INFO(check.name << " " << check.value);
        CHECK(check.passed());
    }
    peer.spoil = [](PeerFrame& frame) { frame.positions[0][0] += 1e-12 * static_cast<double>(frame.step); };
    for (const Check& check : checks_of(compared(peer, {0, 1, 10}), {1, 10}, agreement)) {
        INFO(check.name << " " << check.value);
        CHECK(check.passed() == (check.name.find("kinetic") != std::string::npos));
    }
    peer.spoil = [](PeerFrame& frame) { frame.positions[0][0] = std::numeric_limits<double>::quiet_NaN(); };
    CHECK_FALSE(checks_of(compared(peer, {0, 1}), {1}, agreement).front().passed());
}

TEST_CASE(
    "kinetic energies are compared beside the larger of what they are and what they were, and only where there is a "
    "limit") {
    MadePeer peer(warm_crystal());
    const double start = kinetic_energy(peer.fluid);
    peer.spoil = [&](PeerFrame& frame) {
        if (frame.step > 0) {
            frame.kinetic_energy = 1e-3 * start;  // as few atoms at a turning point may have
        }
    };
    const TrajectoryComparison still = compared(peer, {0, 1});
    const double ours =
        follow(peer.fluid, *MadePeer::force_field_of(peer.fluid), "leapfrog", 0.004, {0, 1})[1].kinetic_energy;
    CHECK(still.rows[1].kinetic_difference == Approx(ours / start - 1e-3).epsilon(1e-9));
    const auto names = [&](const Agreement& agreement) {
        std::string all;
        for (const Check& check : checks_of(still, {1}, agreement)) {
            all += check.name + "\n";
        }
        return all;
    };
    CHECK_THAT(names(double_agreement({})), Catch::Contains("kinetic"));
    CHECK_THAT(names(double_agreement({.temperature = 0.0})), !Catch::Contains("kinetic"));
}

TEST_CASE("the rate of divergence is the exponent of the distances") {
    TrajectoryComparison comparison;
    for (Index step = 0; step <= 1000; step += 10) {
        const double t = 0.004 * static_cast<double>(step);
        // Rounding at first, then growth, then cages: only the growth counts.
        comparison.rows.push_back({step, t, {std::min(0.5, 1e-14 * std::exp(3.75 * t * 2.0))}, 0.0, 0.0});
    }
    CHECK(comparison.divergence_rate().value() == Approx(7.5).epsilon(1e-9));
    comparison.rows.resize(7);
    CHECK_FALSE(comparison.divergence_rate());
}
