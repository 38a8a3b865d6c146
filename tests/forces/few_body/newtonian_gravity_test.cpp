#include <Eigen/Geometry>
#include <cmath>
#include "catch.hpp"

#include "forces/made_few_body_force.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;

namespace {

const test::Numbers unit_gravity = {{"gravitational_constant", 1.0}};

/// Three bodies at a right angle with sides 3, 4 and 5.
State triangle() {
    return test::bodies_at({{0.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, {0.0, 4.0, 0.0}}, {2.0, 3.0, 5.0});
}

Vec3 force_on(const State& state, Index i) {
    return state.forces().col(i);
}

}  // namespace

TEST_CASE("gravity between three bodies is what one computes by hand") {
    const auto force = test::made_few_body_force("newtonian-gravity", {{"gravitational_constant", 2.0}});
    State state = triangle();
    const Evaluation evaluation = force->evaluate(state, Request::forces_and_energy);
    // Pairs G m m / r: 2 * 6 / 3, 2 * 10 / 4, 2 * 15 / 5.
    CHECK(evaluation.potential_energy == Approx(-4.0 - 5.0 - 6.0).epsilon(1e-14));
    // On body 1: 2 * 6 / 9 towards +x and 2 * 10 / 16 towards +y.
    CHECK((force_on(state, 0) - Vec3(4.0 / 3.0, 1.25, 0.0)).norm() < 1e-14);
    // On body 3: 20/16 downwards, and 30/25 along (3, -4)/5.
    CHECK((force_on(state, 2) - Vec3(0.72, -1.25 - 0.96, 0.0)).norm() < 1e-14);
    CHECK((force_on(state, 1) - Vec3(-4.0 / 3.0 - 0.72, 0.96, 0.0)).norm() < 1e-14);
}

TEST_CASE("softening adds to squared distances and a central mass attracts every body") {
    // All at distance 5 with softening 12: (25 + 144)^(1/2) = 13.
    const auto soft =
        test::made_few_body_force("newtonian-gravity", {{"gravitational_constant", 1.0}, {"softening", 12.0}});
    State pair = test::bodies_at({{0.0, 0.0, 0.0}, {0.0, 3.0, 4.0}}, {13.0, 169.0});
    CHECK(soft->evaluate(pair, Request::forces_and_energy).potential_energy == Approx(-169.0).epsilon(1e-14));
    CHECK((force_on(pair, 0) - Vec3(0.0, 3.0, 4.0)).norm() < 1e-14);

    const auto central = test::made_few_body_force(
        "newtonian-gravity", {{"gravitational_constant", 1.0}, {"softening", 12.0}, {"central_mass", 13.0}});
    State one = test::bodies_at({{0.0, 3.0, 4.0}}, {169.0});
    CHECK(central->evaluate(one, Request::forces_and_energy).potential_energy == Approx(-169.0).epsilon(1e-14));
    CHECK((force_on(one, 0) + Vec3(0.0, 3.0, 4.0)).norm() < 1e-14);
}

TEST_CASE("a body in the field of a central mass accelerates as two bodies towards each other") {
    const double m1 = 1.0;
    const double m2 = 0.25;
    const Vec3 d(0.6, -0.8, 1.1);
    State two = test::bodies_at({{0.2, 0.1, 0.0}, Vec3(0.2, 0.1, 0.0) + d}, {m1, m2});
    test::made_few_body_force("newtonian-gravity", unit_gravity)->evaluate(two, Request::forces);
    State one = test::bodies_at({d}, {1.0});
    test::made_few_body_force("newtonian-gravity", {{"gravitational_constant", 1.0}, {"central_mass", m1 + m2}})
        ->evaluate(one, Request::forces);
    CHECK((force_on(two, 1) / m2 - force_on(two, 0) / m1 - force_on(one, 0)).norm() < 1e-14);
}

TEST_CASE("gravity between bodies keeps momentum and angular momentum, and its virial is its energy") {
    const auto force = test::made_few_body_force("newtonian-gravity", unit_gravity);
    State state =
        test::bodies_at({{0.8, 0.3, -0.4}, {1.7, -0.9, 0.2}, {0.5, 1.1, 0.9}, {2.6, 0.4, -1.3}}, {1.0, 2.5, 0.3, 4.0});
    const Evaluation evaluation = force->evaluate(state, Request::forces_and_energy);
    const Eigen::Matrix3Xd f = static_cast<const State&>(state).forces();
    CHECK(f.rowwise().sum().norm() < 1e-15 * f.norm());
    Vec3 torque = Vec3::Zero();
    for (Index i = 0; i < state.count(); ++i) {
        torque += Vec3(static_cast<const State&>(state).positions().col(i)).cross(Vec3(f.col(i)));
    }
    CHECK(torque.norm() < 1e-14 * f.norm());
    CHECK(evaluation.virial.trace() == Approx(evaluation.potential_energy).epsilon(1e-14));
}

TEST_CASE("the forces of two bodies on each other are opposite to the last bit") {
    const auto force = test::made_few_body_force("newtonian-gravity", {{"gravitational_constant", 0.3}});
    State state = test::bodies_at({{0.1, 0.7, -0.3}, {1.9, 0.2, 0.6}}, {0.7, 1.1e-3});
    force->evaluate(state, Request::forces);
    CHECK(force_on(state, 0) == -force_on(state, 1));
}

TEST_CASE("two bodies at one place are no start and stop a run, unless softened") {
    State state =
        test::bodies_at({{9.0, 9.0, 9.0}, {1.0, 2.0, 0.0}, {0.5, 0.5, 0.0}, {1.0, 2.0, 0.0}}, {1.0, 1.0, 1.0, 1.0});
    const auto problem = test::problem_at_start("newtonian-gravity", unit_gravity, state);
    REQUIRE(problem);
    CHECK(problem->body == 3);
    CHECK_THAT(problem->message, Catch::Contains("bodies 2 and 4") && Catch::Contains("(1, 2, 0)"));
    const auto force = test::made_few_body_force("newtonian-gravity", unit_gravity);
    CHECK_THROWS_AS(force->evaluate(state, Request::forces), PhysicsError);
    CHECK_THROWS_WITH(force->evaluate(state, Request::forces), Catch::Contains("bodies 2 and 4"));

    const test::Numbers softened = {{"gravitational_constant", 1.0}, {"softening", 0.1}};
    CHECK_FALSE(test::problem_at_start("newtonian-gravity", softened, state));
    test::made_few_body_force("newtonian-gravity", softened)->evaluate(state, Request::forces);
    CHECK(static_cast<const State&>(state).forces().allFinite());
}

TEST_CASE("bodies closer than numbers can tell have collided") {
    State state = test::bodies_at({{0.0, 0.0, 0.0}, {1e-150, 0.0, 0.0}}, {1.0, 1.0});
    CHECK(test::problem_at_start("newtonian-gravity", unit_gravity, state));
    CHECK_THROWS_WITH(test::made_few_body_force("newtonian-gravity", unit_gravity)->evaluate(state, Request::forces),
                      Catch::Contains("bodies 1 and 2"));
}

TEST_CASE("a body at the origin collides with a central mass alone") {
    State state = test::bodies_at({{1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}, {1.0, 1.0});
    CHECK_FALSE(test::problem_at_start("newtonian-gravity", unit_gravity, state));
    const test::Numbers central = {{"gravitational_constant", 1.0}, {"central_mass", 2.0}};
    const auto problem = test::problem_at_start("newtonian-gravity", central, state);
    REQUIRE(problem);
    CHECK(problem->body == 1);
    CHECK_THAT(problem->message, Catch::Contains("body 2") && Catch::Contains("central mass"));
    CHECK_THROWS_WITH(test::made_few_body_force("newtonian-gravity", central)->evaluate(state, Request::forces),
                      Catch::Contains("body 2") && Catch::Contains("central mass"));
}
