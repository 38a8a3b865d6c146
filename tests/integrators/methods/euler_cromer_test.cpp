#include "catch.hpp"

#include "integrators/oscillator.hpp"

using namespace ljmd;

TEST_CASE("a step of Euler-Cromer moves with the new velocity") {
    test::Oscillator springs(2.0);
    const State start = test::swinging(springs);
    State end = start;
    test::advance("euler-cromer", {}, 0.125, 1, end, springs);
    for (Index i = 0; i < 2; ++i) {
        const double mass = start.masses()[static_cast<std::size_t>(i)];
        const Vec3 v = start.velocities().col(i) + 0.125 / mass * start.forces().col(i);
        CHECK((test::velocities(end).col(i) - v).norm() < 1e-15);
        CHECK((test::positions(end).col(i) - (start.positions().col(i) + 0.125 * v)).norm() < 1e-15);
    }
}

TEST_CASE("Euler-Cromer conserves v^2 + omega^2 x^2 - omega^2 dt x v of an oscillator, not the energy") {
    test::Oscillator springs(2.0);
    State state = test::swinging(springs);
    const double omega2 = 2.0;
    const auto x = [&] { return test::positions(state)(0, 0); };
    const auto v = [&] { return test::velocities(state)(0, 0); };
    const auto energy = [&] { return v() * v() + omega2 * x() * x(); };
    const auto shadow = [&] { return energy() - omega2 * 0.1 * x() * v(); };
    const double energy_before = energy();
    const double shadow_before = shadow();
    double largest = 0.0;
    for (int n = 0; n < 1000; ++n) {
        test::advance("euler-cromer", {}, 0.1, 1, state, springs);
        CHECK(shadow() == Approx(shadow_before).epsilon(1e-12));
        largest = std::max(largest, std::abs(energy() / energy_before - 1.0));
    }
    CHECK(largest > 0.05);
    CHECK(largest < 0.2);
}

TEST_CASE("with v(0) set back by half a kick Euler-Cromer goes through the positions of leapfrog") {
    test::Oscillator springs(2.0);
    State cromer = test::swinging(springs);
    State leapfrog = cromer;
    for (Index i = 0; i < 2; ++i) {
        cromer.write_velocities().col(i) -=
            0.05 / cromer.masses()[static_cast<std::size_t>(i)] * test::forces(leapfrog).col(i);
    }
    test::advance("euler-cromer", {}, 0.1, 100, cromer, springs);
    test::advance("leapfrog", {}, 0.1, 100, leapfrog, springs);
    CHECK((test::positions(cromer) - test::positions(leapfrog)).norm() < 1e-13);
}
