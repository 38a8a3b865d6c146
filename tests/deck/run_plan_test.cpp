#include "deck/run_plan.hpp"

#include "deck/deck_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;

TEST_CASE("a plan of either kind has stages, samples and units") {
    RunPlan fluid;
    fluid.spec = FluidSpec{.stages = {{.name = "melt"}}, .sample_every = 7, .units = SubstanceUnits(1.0, 2.0, 3.0)};
    CHECK(fluid.is_fluid());
    CHECK(kind_name(fluid) == "fluid");
    CHECK(fluid.sample_every() == 7);
    CHECK(fluid.units().has_value());
    fluid.stages().front().steps = 3;
    CHECK(total_steps(std::as_const(fluid).stages()) == 3);
    CHECK_NOTHROW(require_fluid(fluid, "no"));
    CHECK_THROWS_WITH(require_few_bodies(fluid, "no"), "no");

    RunPlan bodies;
    bodies.spec = FewBodySpec{.stages = {{.name = "swing"}}, .sample_every = 2};
    CHECK_FALSE(bodies.is_fluid());
    CHECK(kind_name(bodies) == "few-body");
    CHECK(bodies.stages().front().name == "swing");
    CHECK(bodies.sample_every() == 2);
    CHECK_FALSE(bodies.units().has_value());
    CHECK_THROWS_AS(require_fluid(bodies, "no"), InputError);
}

TEST_CASE("the potential that a program gave takes the place of its stand-in") {
    RunPlan plan;
    plan.spec = FluidSpec{.potential = PairPotential::lennard_jones("shifted", {2.0, 0.0})};
    plan.given.potential = GivenPotential{"soft", "shifted", {1.5, 0.0}, "", {}, {}, "it is not known"};
    CHECK_THROWS_WITH(fluid_spec(plan), "it is not known");
    CHECK_THROWS_AS(fluid_spec(plan), DataError);
    plan.given.potential->potential = PairPotential::lennard_jones("shifted", {1.5, 0.0});
    CHECK(fluid_spec(plan).potential.cutoff().radius == 1.5);
}
