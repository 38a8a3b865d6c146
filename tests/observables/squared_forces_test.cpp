#include "observables/squared_forces.hpp"

#include "catch.hpp"

using namespace ljmd;

TEST_CASE("squares of forces are divided by the masses and added") {
    State state(2, Box(Vec3(5.0, 5.0, 5.0)));
    state.write_masses()[1] = 2.0;
    state.write_forces().col(0) = Vec3(1.0, 2.0, 2.0);
    state.write_forces().col(1) = Vec3(0.0, 4.0, 0.0);
    CHECK(squared_forces_over_mass(state) == 9.0 + 8.0);
}
