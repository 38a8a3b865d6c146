#include "catch.hpp"

#include "integrators/oscillator.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;

TEST_CASE("bit-reversible returns to its start bit for bit, from any start, after any number of steps") {
    test::Oscillator springs(2.0);
    for (const Index steps : {1, 2, 1000}) {
        for (const double x : {1.0, 1.0 / 3.0, -0.7}) {
            State state = test::swinging(springs);
            state.write_positions()(0, 0) = x;
            const Integrator integrator(find_integrator("bit-reversible"), 0.1);
            integrator.step(state, springs, Request::forces);
            const Eigen::Matrix3Xd r = test::positions(state);
            const Eigen::Matrix3Xd v = test::velocities(state);
            for (Index n = 0; n < steps; ++n) {
                integrator.step(state, springs, Request::forces);
            }
            CHECK(test::positions(state) != r);
            integrator.reverse(state, springs);
            for (Index n = 0; n < steps; ++n) {
                integrator.step(state, springs, Request::forces);
            }
            CHECK(test::positions(state) == r);
            CHECK(test::velocities(state) == -v);
        }
    }
}

TEST_CASE("bit-reversible is position Verlet to the rounding of its grid") {
    test::Oscillator springs(2.0);
    State integer = test::swinging(springs);
    State real = integer;
    test::advance("bit-reversible", {}, 0.1, 200, integer, springs);
    test::advance("position-verlet", {}, 0.1, 200, real, springs);
    CHECK((test::positions(integer) - test::positions(real)).norm() < 1e-9);
    CHECK((test::positions(integer) - test::positions(real)).norm() > 0.0);
}

TEST_CASE("bit-reversible asks for forces that do not depend on the order of atoms") {
    test::Oscillator springs(2.0);
    State state = test::swinging(springs);
    const std::size_t before = springs.requests().size();
    test::advance("bit-reversible", {}, 0.1, 3, state, springs);
    for (std::size_t k = before; k < springs.requests().size(); ++k) {
        CHECK(springs.requests()[k].order_independent);
    }
    CHECK(springs.requests().size() == before + 4);
}

TEST_CASE("a body that leaves the grid of bit-reversible ends the run") {
    test::Oscillator nothing(0.0);
    State state = test::swinging(nothing);
    state.write_velocities()(0, 0) = 100.0;
    CHECK_THROWS_AS(test::advance("bit-reversible", {}, 1.0, 10, state, nothing), PhysicsError);
}
