#include <catch2/catch.hpp>
#include <cmath>

#include "forces/made_few_body_force.hpp"

using namespace ljmd;

namespace {

const double pi = std::acos(-1.0);

}  // namespace

TEST_CASE("a pendulum at 30 degrees, level and upright is what one computes by hand") {
    const auto force = test::made_few_body_force("pendulum", {{"gravity", 9.0}, {"length", 1.5}});
    State state = test::bodies_at({{pi / 6.0, 0.0, 0.0}, {-pi / 2.0, 0.0, 0.0}, {pi, 0.0, 0.0}}, {2.0, 1.0, 1.0});
    const Evaluation evaluation = force->evaluate(state, Request::forces_and_energy);
    const auto f = static_cast<const State&>(state).forces();
    CHECK(f(0, 0) == Approx(-6.0).epsilon(1e-14));  // -m (g/l) sin(30 degrees) = -2 * 6 / 2
    CHECK(f(0, 1) == Approx(6.0).epsilon(1e-14));
    CHECK(std::abs(f(0, 2)) < 1e-14);
    CHECK(evaluation.potential_energy == Approx(12.0 * (1.0 - std::sqrt(0.75)) + 6.0 + 12.0).epsilon(1e-14));
}

TEST_CASE("the energy of a pendulum is accurate for small angles") {
    const auto force = test::made_few_body_force("pendulum", {{"gravity", 1.0}, {"length", 1.0}});
    State state = test::bodies_at({{1e-9, 0.0, 0.0}}, {1.0});
    CHECK(force->evaluate(state, Request::forces_and_energy).potential_energy == Approx(0.5e-18).epsilon(1e-14));
}
