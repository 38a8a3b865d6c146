#include <cmath>
#include <limits>
#include "catch.hpp"

#include "forces/made_few_body_force.hpp"

using namespace ljmd;

namespace {

const double pi = std::acos(-1.0);

}  // namespace

TEST_CASE("a pendulum at 30 degrees, level and upright is what one computes by hand") {
    const test::Numbers numbers{{"gravity", 9.0}, {"length", 1.5}};
    const auto inertia = [&](double mass) {
        return test::chosen_few_body_force("pendulum", numbers).options->inertia(mass);
    };
    CHECK(inertia(2.0) == 4.5);  // m l^2
    State state = test::bodies_at({{pi / 6.0, 0.0, 0.0}, {-pi / 2.0, 0.0, 0.0}, {pi, 0.0, 0.0}},
                                  {inertia(2.0), inertia(1.0), inertia(1.0)});
    const Evaluation evaluation =
        test::made_few_body_force("pendulum", numbers)->evaluate(state, Request::forces_and_energy);
    const auto f = static_cast<const State&>(state).forces();
    CHECK(f(0, 0) == Approx(-13.5).epsilon(1e-14));  // the torque -m g l sin(30 degrees) = -2 * 9 * 1.5 / 2
    CHECK(f(0, 1) == Approx(13.5).epsilon(1e-14));
    CHECK(std::abs(f(0, 2)) < 1e-14);
    // m g l times 1 - cos(30 degrees), 1 and 2.
    CHECK(evaluation.potential_energy == Approx(27.0 * (1.0 - std::sqrt(0.75)) + 13.5 + 27.0).epsilon(1e-14));
    CHECK(f(0, 0) / inertia(2.0) == Approx(-3.0).epsilon(1e-14));  // theta'' = -(g/l) sin(30 degrees)
}

TEST_CASE("a moment of inertia out of the range of numbers is no start") {
    const test::Numbers numbers{{"gravity", 1.0}, {"length", 1.0}};
    for (const double inertia : {0.0, 1e-320, std::numeric_limits<double>::infinity()}) {
        const auto problem = test::problem_at_start("pendulum", numbers, test::bodies_at({{1.0, 0.0, 0.0}}, {inertia}));
        REQUIRE(problem);
        CHECK_THAT(problem->message, Catch::Contains("body 1 has a moment of inertia m l^2 of"));
    }
    CHECK_FALSE(test::problem_at_start("pendulum", numbers, test::bodies_at({{1.0, 0.0, 0.0}}, {1e-300})));
}

TEST_CASE("the energy of a pendulum is accurate for small angles") {
    const auto force = test::made_few_body_force("pendulum", {{"gravity", 1.0}, {"length", 1.0}});
    State state = test::bodies_at({{1e-9, 0.0, 0.0}}, {1.0});
    CHECK(force->evaluate(state, Request::forces_and_energy).potential_energy == Approx(0.5e-18).epsilon(1e-14));
}
