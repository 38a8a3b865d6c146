#include "catch.hpp"

#include "integrators/oscillator.hpp"

using namespace ljmd;

TEST_CASE("a step of Forest and Ruth is three of velocity Verlet, the middle one backwards") {
    test::Oscillator springs(2.0);
    const double dt = 0.1;
    const double w1 = 1.3512071919596578;
    const double w0 = -1.7024143839193153;
    State composed = test::swinging(springs);
    State single = composed;
    test::advance("forest-ruth", {}, dt, 1, composed, springs);
    test::advance("velocity-verlet", {}, w1 * dt, 1, single, springs);
    test::advance("velocity-verlet", {}, w0 * dt, 1, single, springs);
    test::advance("velocity-verlet", {}, w1 * dt, 1, single, springs);
    CHECK((test::positions(composed) - test::positions(single)).norm() < 1e-15);
    CHECK((test::velocities(composed) - test::velocities(single)).norm() < 1e-15);
}

TEST_CASE("Forest and Ruth evaluate the forces three times a step") {
    test::Oscillator springs(2.0);
    State state = test::swinging(springs);
    const std::size_t before = springs.requests().size();
    test::advance("forest-ruth", {}, 0.1, 5, state, springs);
    CHECK(springs.requests().size() == before + 15);
}
