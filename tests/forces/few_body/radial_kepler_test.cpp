#include <cmath>
#include "catch.hpp"

#include "forces/made_few_body_force.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;

namespace {

const test::Numbers numbers = {{"gravitational_parameter", 3.0}, {"angular_momentum", 2.0}};

}  // namespace

TEST_CASE("the radial Kepler problem at rho = 2 is what one computes by hand") {
    State state = test::bodies_at({{2.0, 0.0, 0.0}}, {5.0});
    const Evaluation evaluation =
        test::made_few_body_force("radial-kepler", numbers)->evaluate(state, Request::forces_and_energy);
    // h^2/rho^3 - mu/rho^2 = 4/8 - 3/4; h^2/(2 rho^2) - mu/rho = 4/8 - 3/2.
    CHECK(static_cast<const State&>(state).forces()(0, 0) == Approx(-1.25).epsilon(1e-15));
    CHECK(evaluation.potential_energy == Approx(-5.0).epsilon(1e-15));
}

TEST_CASE("the angle of the radial Kepler problem turns by h/rho^2, and its rate changes by -2 h rho'/rho^3") {
    const auto [rate, slope] =
        test::chosen_few_body_force("radial-kepler", numbers).options->angular_velocity(2.0, 0.5);
    CHECK(rate == 0.5);
    CHECK(slope == -0.25);
}

TEST_CASE("the radial Kepler problem rests at the radius h^2/mu of the circle") {
    State state = test::bodies_at({{4.0 / 3.0, 0.0, 0.0}}, {5.0});
    test::made_few_body_force("radial-kepler", numbers)->evaluate(state, Request::forces);
    CHECK(std::abs(static_cast<const State&>(state).forces()(0, 0)) < 1e-14);
}

TEST_CASE("a distance that is not positive is no start of the radial Kepler problem and stops a run") {
    const auto force = test::made_few_body_force("radial-kepler", numbers);
    for (const double rho : {0.0, -1.5}) {
        State state = test::bodies_at({{2.0, 0.0, 0.0}, {rho, 0.0, 0.0}}, {1.0, 1.0});
        const auto problem = test::problem_at_start("radial-kepler", numbers, state);
        REQUIRE(problem);
        CHECK(problem->body == 1);
        CHECK_THAT(problem->message, Catch::Contains("body 2") && Catch::Contains("must be > 0"));
        CHECK_THROWS_AS(force->evaluate(state, Request::forces), PhysicsError);
        CHECK_THROWS_WITH(force->evaluate(state, Request::forces), problem->message);
    }
}

TEST_CASE("the angular momentum of the radial Kepler problem may be zero") {
    CHECK_NOTHROW(
        test::few_body_section("radial-kepler", {{"gravitational_parameter", 1.0}, {"angular_momentum", 0.0}}));
    CHECK_THROWS_AS(
        test::few_body_section("radial-kepler", {{"gravitational_parameter", 0.0}, {"angular_momentum", 1.0}}),
        InputError);
}
