#include "catch.hpp"

#include "integrators/oscillator.hpp"

using namespace ljmd;

TEST_CASE("after two steps of tau leapfrog-2tau is where velocity Verlet is after one of 2 tau") {
    test::Oscillator springs(2.0);
    State leapfrog = test::swinging(springs);
    State verlet = leapfrog;
    for (int n = 0; n < 100; ++n) {
        test::advance("leapfrog-2tau", {}, 0.05, 2, leapfrog, springs);
        test::advance("velocity-verlet", {}, 0.1, 1, verlet, springs);
        CHECK((test::positions(leapfrog) - test::positions(verlet)).norm() < 1e-13);
        CHECK((test::velocities(leapfrog) - test::velocities(verlet)).norm() < 1e-13);
    }
}

TEST_CASE("odd velocities and even positions of leapfrog-2tau leap over each other by 2 tau") {
    test::Oscillator springs(2.0);
    const double tau = 0.05;
    const auto after = [&](Index steps) {
        State state = test::swinging(springs);
        test::advance("leapfrog-2tau", {}, tau, steps, state, springs);
        return state;
    };
    const Vec3 kick = 2.0 * tau * -2.0 * test::positions(after(4)).col(0);
    CHECK((test::velocities(after(5)).col(0) - test::velocities(after(3)).col(0) - kick).norm() < 1e-14);
    const Vec3 drift = 2.0 * tau * test::velocities(after(5)).col(0);
    CHECK((test::positions(after(6)).col(0) - test::positions(after(4)).col(0) - drift).norm() < 1e-14);
}
