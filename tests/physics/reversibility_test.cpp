// Newton's equations run backwards: after n steps, reversed velocities lead back to the start.
#include "catch.hpp"

#include "physics/liquid.hpp"

using namespace ljmd;

namespace {

double distance_after_return(Index steps) {
    State state = test::liquid(4, 11);
    auto force_field = test::lennard_jones("force-shifted");
    const auto start = test::unwrapped_by_id(state);
    test::advance(state, force_field, 0.004, steps);
    state.write_velocities() *= -1.0;
    test::advance(state, force_field, 0.004, steps);
    return (test::unwrapped_by_id(state) - start).colwise().norm().maxCoeff();
}

}  // namespace

TEST_CASE("velocity Verlet returns to its start: 100 steps") {
    CHECK(distance_after_return(100) < 1e-13);
}
TEST_CASE("velocity Verlet returns to its start: 500 steps") {
    CHECK(distance_after_return(500) < 1e-10);
}
TEST_CASE("velocity Verlet returns to its start: 1000 steps") {
    CHECK(distance_after_return(1000) < 1e-7);
}
