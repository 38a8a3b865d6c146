#include "engine/stability.hpp"

#include <fmt/format.h>

#include <limits>
#include <utility>
#include <vector>
#include "catch.hpp"

#include "execution/loops.hpp"
#include "execution/test_execution.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/model/lattice.hpp"

using namespace ljmd;

namespace {

constexpr double dt = 0.004;

PairPotential cut_at(double radius) {
    return PairPotential::lennard_jones("cut", {radius, 0.0});
}

/// Atoms of which one has the speed that takes it `move` sigma far in a step.
State with_move(double move) {
    State state(5, cubic_box(5, 0.5));
    state.write_velocities().setConstant(0.1);
    state.write_velocities().col(3) = Vec3(0.0, move / dt, 0.0);
    return state;
}

Thermodynamics energies(double total, double kinetic) {
    Thermodynamics row;
    row.total_energy = total;
    row.kinetic_energy = kinetic;
    return row;
}

}  // namespace

TEST_CASE("a fast atom is noticed and named") {
    const StabilityWatch watch(dt, false, cut_at(2.5));
    CHECK_NOTHROW(watch.check_speeds(with_move(0.0)));
    CHECK_NOTHROW(watch.check_speeds(with_move(0.499)));
    CHECK_THROWS_AS(watch.check_speeds(with_move(0.501)), PhysicsError);
    CHECK_THROWS_AS(watch.check_speeds(with_move(std::numeric_limits<double>::infinity())), PhysicsError);
    CHECK_THROWS_AS(watch.check_speeds(with_move(std::numeric_limits<double>::quiet_NaN())), PhysicsError);
    CHECK_THROWS_WITH(watch.check_speeds(with_move(0.75)),
                      Catch::StartsWith("atom 4 moves 0.75 sigma in one step of 0.004"));

    State reordered = with_move(0.75);
    reordered.reorder({3, 0, 1, 2, 4});
    CHECK_THROWS_WITH(watch.check_speeds(reordered), Catch::StartsWith("atom 4 "));
}

TEST_CASE("the fastest atom of all blocks is named, of equals and of those that are not finite the first") {
    const Execution execution = test::with_threads(GENERATE(1, 2));
    const StabilityWatch watch(dt, false, cut_at(2.5));
    const Index atoms = 3 * loop_block;
    const auto message_starts = [&](const std::vector<std::pair<Index, double>>& moves, const std::string& start) {
        State state(atoms, cubic_box(atoms, 0.5), execution);
        for (const auto& [atom, move] : moves) {
            state.write_velocities()(0, atom) = move / dt;
        }
        CHECK_THROWS_WITH(watch.check_speeds(state), Catch::StartsWith(start));
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    message_starts({{10, 0.6}, {loop_block + 1, 0.8}, {2 * loop_block, 0.7}}, fmt::format("atom {} ", loop_block + 2));
    message_starts({{10, 0.8}, {2 * loop_block, 0.8}}, "atom 11 ");
    message_starts({{10, 0.8}, {loop_block, nan}, {2 * loop_block, nan}}, fmt::format("atom {} ", loop_block + 1));
}

TEST_CASE("a rising total energy is noticed at constant energy only") {
    const double allowed = 0.1 + 0.1 * 1.5 + 3.0 * 4.0 * (std::pow(2.5, -6) - std::pow(2.5, -12));
    StabilityWatch watch(dt, true, cut_at(2.5));
    CHECK_NOTHROW(watch.check_energy(energies(-5.0, 1.0)));
    CHECK_NOTHROW(watch.check_energy(energies(-5.0 + 0.999 * allowed, 1.5)));
    CHECK_NOTHROW(watch.check_energy(energies(-9.0, 1.0)));  // pairs that leave a plain cut may take energy along
    CHECK_THROWS_WITH(watch.check_energy(energies(-5.0 + 1.001 * allowed, 1.5)),
                      Catch::Contains("has risen") && Catch::Contains("time step of 0.004 tau"));
    CHECK_THROWS_AS(watch.check_energy(energies(std::numeric_limits<double>::quiet_NaN(), 1.0)), PhysicsError);

    StabilityWatch thermostatted(dt, false, cut_at(2.5));
    thermostatted.check_energy(energies(-5.0, 1.0));
    CHECK_NOTHROW(thermostatted.check_energy(energies(5.0, 1.0)));
}

TEST_CASE("a harsh cut is allowed its jumps") {
    StabilityWatch harsh(dt, true, cut_at(1.5));
    harsh.check_energy(energies(-5.0, 1.0));
    CHECK_NOTHROW(harsh.check_energy(energies(-4.0, 1.0)));
    StabilityWatch smooth(dt, true, PairPotential::lennard_jones("force-shifted", {1.5, 0.0}));
    smooth.check_energy(energies(-5.0, 1.0));
    CHECK_THROWS_AS(smooth.check_energy(energies(-4.0, 1.0)), PhysicsError);
}
