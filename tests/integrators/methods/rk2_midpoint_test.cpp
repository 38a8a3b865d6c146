#include "catch.hpp"

#include "integrators/oscillator.hpp"

using namespace ljmd;

TEST_CASE("a step of the Runge-Kutta midpoint method takes its slopes from the midpoint") {
    test::Oscillator springs(2.0);
    const State start = test::swinging(springs);
    State end = start;
    test::advance("rk2-midpoint", {}, 0.125, 1, end, springs);
    for (Index i = 0; i < 2; ++i) {
        const double mass = start.masses()[static_cast<std::size_t>(i)];
        const Vec3 r0 = start.positions().col(i);
        const Vec3 v0 = start.velocities().col(i);
        const Vec3 r_mid = r0 + 0.0625 * v0;
        const Vec3 v_mid = v0 + 0.0625 / mass * (-2.0 * r0);
        CHECK((test::positions(end).col(i) - (r0 + 0.125 * v_mid)).norm() < 1e-15);
        CHECK((test::velocities(end).col(i) - (v0 + 0.125 / mass * (-2.0 * r_mid))).norm() < 1e-15);
    }
}

TEST_CASE("the Runge-Kutta midpoint method multiplies the energy of an oscillator by 1 + (omega dt)^4 / 4 each step") {
    test::Oscillator springs(2.0);
    State state = test::swinging(springs);
    const auto energy = [&] {
        return test::velocities(state).col(0).squaredNorm() + 2.0 * test::positions(state).col(0).squaredNorm();
    };
    const double before = energy();
    test::advance("rk2-midpoint", {}, 0.1, 200, state, springs);
    CHECK(energy() == Approx(before * std::pow(1.0 + std::pow(2.0 * 0.01, 2) / 4.0, 200)).epsilon(1e-12));
}
