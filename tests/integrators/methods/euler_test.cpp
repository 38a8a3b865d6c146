#include "catch.hpp"

#include "integrators/oscillator.hpp"

using namespace ljmd;

TEST_CASE("a step of Euler uses the old position and the old velocity") {
    test::Oscillator springs(2.0);
    const State start = test::swinging(springs);
    State end = start;
    test::advance("euler", {}, 0.125, 1, end, springs);
    for (Index i = 0; i < 2; ++i) {
        const double mass = start.masses()[static_cast<std::size_t>(i)];
        CHECK((test::positions(end).col(i) - (start.positions().col(i) + 0.125 * start.velocities().col(i))).norm() <
              1e-15);
        const Vec3 v = start.velocities().col(i) + 0.125 / mass * start.forces().col(i);
        CHECK((test::velocities(end).col(i) - v).norm() < 1e-15);
    }
}

TEST_CASE("Euler multiplies the energy of an oscillator by 1 + (omega dt)^2 each step") {
    test::Oscillator springs(2.0);
    State state = test::swinging(springs);
    const auto energy = [&](Index i) {
        const double omega = springs.frequency(state.masses()[static_cast<std::size_t>(i)]);
        return test::velocities(state).col(i).squaredNorm() +
               omega * omega * test::positions(state).col(i).squaredNorm();
    };
    const double before[] = {energy(0), energy(1)};
    test::advance("euler", {}, 0.1, 50, state, springs);
    CHECK(energy(0) == Approx(before[0] * std::pow(1.0 + 2.0 * 0.01, 50)).epsilon(1e-12));
    CHECK(energy(1) == Approx(before[1] * std::pow(1.0 + 0.8 * 0.01, 50)).epsilon(1e-12));
}
