#include "catch.hpp"

#include "integrators/oscillator.hpp"
#include "integrators/reference_trajectory.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/model/box.hpp"

using namespace ljmd;

TEST_CASE("a step of Prince and Dormand is the reference solution over that time, whatever the time step") {
    test::Oscillator springs(2.0);
    const State start = test::swinging(springs);
    ReferenceTrajectory reference(start, springs, 1e-13);
    const State exact = reference.advance_to(3.0);
    for (const double dt : {3.0, 0.5, 0.01}) {
        State state = start;
        test::advance("prince-dormand", {}, dt, static_cast<Index>(std::lround(3.0 / dt)), state, springs);
        CHECK((test::positions(state) - test::positions(exact)).norm() < 1e-12);
        CHECK((test::velocities(state) - test::velocities(exact)).norm() < 1e-12);
    }
}

TEST_CASE("Prince and Dormand keep bodies apart that lie in another order, and their time") {
    test::Oscillator springs(2.0);
    State state = test::swinging(springs);
    State other = state;
    state.time = 7.0;
    other.reorder({1, 0});
    test::advance("prince-dormand", {}, 1.0, 1, state, springs);
    test::advance("prince-dormand", {}, 1.0, 1, other, springs);
    CHECK(test::positions(state).col(0) == test::positions(other).col(1));
    CHECK(test::velocities(state).col(1) == test::velocities(other).col(0));
    CHECK(state.time == 7.0);
}

TEST_CASE("Prince and Dormand refuse a box") {
    test::Oscillator springs(2.0);
    State state(1, Box(Vec3::Constant(5.0)));
    CHECK_THROWS_AS(test::advance("prince-dormand", {}, 1.0, 1, state, springs), ContractViolation);
}
