#include "compare/fluid.hpp"

#include "catch.hpp"

#include "model/velocities.hpp"

using namespace ljmd;

namespace {

/// Three atoms in a box of edge 4, out of order in memory, one of them outside.
State three_atoms() {
    State state(3, Box(Vec3(4.0, 4.0, 4.0)));
    auto r = state.write_positions();
    r.col(0) = state.snapped(Vec3(0.5, 1.0, 1.5));
    r.col(1) = state.snapped(Vec3(4.25, -0.5, 2.0));
    r.col(2) = state.snapped(Vec3(3.0, 3.0, 3.0));
    auto v = state.write_velocities();
    v.col(0) = Vec3(1.0, 0.0, 0.0);
    v.col(1) = Vec3(0.0, 2.0, 0.0);
    v.col(2) = Vec3(0.0, 0.0, 3.0);
    state.write_masses() = {1.0, 2.0, 4.0};
    state.reorder({2, 0, 1});
    return state;
}

PairPotential lennard_jones() {
    return PairPotential::lennard_jones("cut", {.radius = 1.5});
}

}  // namespace

TEST_CASE("a fluid lists its atoms by id, in the box") {
    const State state = three_atoms();
    const Fluid fluid = fluid_of(state, lennard_jones(), true);
    REQUIRE(fluid.edges == Vec3(4.0, 4.0, 4.0));
    REQUIRE(fluid.tail);
    REQUIRE(fluid.positions == std::vector<Vec3>{{0.5, 1.0, 1.5}, {0.25, 3.5, 2.0}, {3.0, 3.0, 3.0}});
    REQUIRE(fluid.velocities == std::vector<Vec3>{{1.0, 0.0, 0.0}, {0.0, 2.0, 0.0}, {0.0, 0.0, 3.0}});
    REQUIRE(fluid.masses == std::vector<double>{1.0, 2.0, 4.0});
    // The state is as it was.
    REQUIRE(state.positions().col(2) == Vec3(4.25, -0.5, 2.0));
}

TEST_CASE("a state made of a fluid makes the same fluid") {
    const Fluid fluid = fluid_of(three_atoms(), lennard_jones(), false);
    const State state = state_of(fluid);
    REQUIRE(state.ids() == std::vector<Index>{0, 1, 2});
    const Fluid again = fluid_of(state, lennard_jones(), false);
    REQUIRE(again.positions == fluid.positions);
    REQUIRE(again.velocities == fluid.velocities);
    REQUIRE(again.masses == fluid.masses);
}

TEST_CASE("the kinetic energy of a fluid is that of its state") {
    const State state = three_atoms();
    REQUIRE(kinetic_energy(fluid_of(state, lennard_jones(), false)) == Approx(22.5).epsilon(1e-15));
    REQUIRE(kinetic_energy(state) == Approx(22.5).epsilon(1e-15));
}
