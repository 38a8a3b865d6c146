#include "ljmd/detail/observables/few_body/few_body.hpp"

#include <Eigen/Geometry>
#include "catch.hpp"

#include "model/velocities.hpp"

using namespace ljmd;

namespace {

State three_bodies() {
    State state(3);
    state.write_masses() = {1.0, 2.0, 5.0};
    state.write_positions() << 1.0, 0.0, -2.0,  //
        0.0, 3.0, 1.0,                          //
        0.5, -1.0, 2.0;
    state.write_velocities() << 0.0, 1.0, 0.25,  //
        2.0, 0.0, -1.0,                          //
        0.0, -0.5, 1.0;
    return state;
}

}  // namespace

TEST_CASE("Angular momentum and centre of mass are those summed by hand") {
    const State state = three_bodies();
    // m r x v: 1 (-1, 0, 2), 2 (-1.5, -1, -3), 5 (3, 2.5, 1.75)
    CHECK(angular_momentum(state) == Vec3(11.0, 10.5, 4.75));
    CHECK(centre_of_mass(state) == Vec3(-9.0, 11.0, 8.5) / 8.0);
}

TEST_CASE("Moving the origin by d changes the angular momentum by d x P and the centre of mass by d") {
    const State before = three_bodies();
    State after = three_bodies();
    const Vec3 shift(0.5, -1.0, 2.0);
    after.write_positions().colwise() += shift;
    const Vec3 change = angular_momentum(after) - angular_momentum(before);
    CHECK((change - shift.cross(total_momentum(before))).norm() < 1e-14);
    CHECK((centre_of_mass(after) - centre_of_mass(before) - shift).norm() < 1e-14);
}
