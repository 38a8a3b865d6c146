#include "catch.hpp"

#include "integrators/oscillator.hpp"

using namespace ljmd;

TEST_CASE("a step of drift-kick-drift is half drift, kick, half drift") {
    test::Oscillator springs(2.0);
    const State start = test::swinging(springs);
    State end = start;
    test::advance("drift-kick-drift", {}, 0.125, 1, end, springs);
    for (Index i = 0; i < 2; ++i) {
        const double mass = start.masses()[static_cast<std::size_t>(i)];
        const Vec3 r_half = start.positions().col(i) + 0.0625 * start.velocities().col(i);
        const Vec3 v = start.velocities().col(i) + 0.125 / mass * (-2.0 * r_half);
        CHECK((test::velocities(end).col(i) - v).norm() < 1e-15);
        CHECK((test::positions(end).col(i) - (r_half + 0.0625 * v)).norm() < 1e-15);
    }
}

TEST_CASE("half-step positions of drift-kick-drift follow Verlet's formula, those at full steps do not") {
    test::Oscillator springs(2.0);
    const double dt = 0.1;
    const auto after = [&](Index steps) {
        State state = test::swinging(springs);
        test::advance("drift-kick-drift", {}, dt, steps, state, springs);
        return state;
    };
    const auto half = [&](Index steps) -> Eigen::Matrix3Xd {
        const State state = after(steps);
        return state.positions() + 0.5 * dt * state.velocities();
    };
    const auto miss = [&](const Eigen::Matrix3Xd& before, const Eigen::Matrix3Xd& now, const Eigen::Matrix3Xd& next) {
        const Vec3 verlet = 2.0 * now.col(0) - before.col(0) - dt * dt * 2.0 * now.col(0);
        return (next.col(0) - verlet).norm();
    };
    CHECK(miss(half(4), half(5), half(6)) < 1e-14);
    State velocity_verlet = test::swinging(springs);
    test::advance("velocity-verlet", {}, dt, 6, velocity_verlet, springs);
    CHECK((after(6).positions() - test::positions(velocity_verlet)).norm() > 1e-4);
}
