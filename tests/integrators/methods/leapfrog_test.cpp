#include "catch.hpp"

#include "integrators/oscillator.hpp"

using namespace ljmd;

TEST_CASE("leapfrog starts half a step back and leaps over the positions") {
    test::Oscillator springs(2.0);
    const double dt = 0.125;
    const State start = test::swinging(springs);
    State end = start;
    test::advance("leapfrog", {}, dt, 2, end, springs);
    for (Index i = 0; i < 2; ++i) {
        const double a = -2.0 / start.masses()[static_cast<std::size_t>(i)];
        Vec3 r = start.positions().col(i);
        Vec3 u = start.velocities().col(i) - 0.5 * dt * a * r;
        for (int n = 0; n < 2; ++n) {
            u += dt * a * r;
            r += dt * u;
        }
        CHECK((test::positions(end).col(i) - r).norm() < 1e-15);
        CHECK((test::velocities(end).col(i) - (u + 0.5 * dt * a * r)).norm() < 1e-15);
    }
}

TEST_CASE("leapfrog is velocity Verlet to rounding, and evaluates the forces once a step") {
    test::Oscillator springs(2.0);
    State leapfrog = test::swinging(springs);
    State verlet = leapfrog;
    test::advance("velocity-verlet", {}, 0.1, 1000, verlet, springs);
    const std::size_t before = springs.requests().size();
    test::advance("leapfrog", {}, 0.1, 1000, leapfrog, springs);
    CHECK(springs.requests().size() == before + 1000);
    CHECK((test::positions(leapfrog) - test::positions(verlet)).norm() < 1e-12);
    CHECK((test::velocities(leapfrog) - test::velocities(verlet)).norm() < 1e-12);
}
