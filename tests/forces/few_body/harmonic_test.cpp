#include "catch.hpp"

#include "forces/made_few_body_force.hpp"

using namespace ljmd;

TEST_CASE("springs to the origin are what one computes by hand, whatever the masses") {
    const auto force = test::made_few_body_force("harmonic", {{"stiffness", 2.0}});
    State state = test::bodies_at({{1.0, -2.0, 3.0}, {0.0, 0.0, 0.0}, {0.5, 0.0, 0.0}}, {1.0, 2.0, 30.0});
    const Evaluation evaluation = force->evaluate(state, Request::forces_and_energy);
    const auto f = static_cast<const State&>(state).forces();
    CHECK(f.col(0) == Vec3(-2.0, 4.0, -6.0));
    CHECK(f.col(1) == Vec3::Zero());
    CHECK(f.col(2) == Vec3(-1.0, 0.0, 0.0));
    CHECK(evaluation.potential_energy == 14.25);
    CHECK(evaluation.virial.trace() == -28.5);
}
