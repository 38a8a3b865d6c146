#include "catch.hpp"

#include "integrators/oscillator.hpp"

using namespace ljmd;

TEST_CASE("a step of Garcia's midpoint moves with the mean of the old and the new velocity") {
    test::Oscillator springs(2.0);
    const State start = test::swinging(springs);
    State end = start;
    test::advance("garcia-midpoint", {}, 0.125, 1, end, springs);
    for (Index i = 0; i < 2; ++i) {
        const double mass = start.masses()[static_cast<std::size_t>(i)];
        const Vec3 v0 = start.velocities().col(i);
        const Vec3 v1 = v0 + 0.125 / mass * start.forces().col(i);
        CHECK((test::velocities(end).col(i) - v1).norm() < 1e-15);
        CHECK((test::positions(end).col(i) - (start.positions().col(i) + 0.125 * (v0 + v1) / 2.0)).norm() < 1e-15);
    }
}

TEST_CASE("Garcia's midpoint gains energy, unlike the Verlet family") {
    test::Oscillator springs(2.0);
    State state = test::swinging(springs);
    const auto energy = [&] {
        return test::velocities(state).col(0).squaredNorm() + 2.0 * test::positions(state).col(0).squaredNorm();
    };
    const double before = energy();
    test::advance("garcia-midpoint", {}, 0.1, 100, state, springs);
    // |1 - z^2/2 ...|: the step matrix of an oscillator has determinant 1 + (omega dt)^2 / 2.
    CHECK(energy() == Approx(before * std::pow(1.0 + 0.5 * 2.0 * 0.01, 100)).epsilon(0.1));
}
