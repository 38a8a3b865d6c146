#include "run/spec_plan.hpp"

#include "deck/deck_fixtures.hpp"
#include "engine/engine_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

RunPlan planned(const FluidSpec& spec, const RunFiles& files = {}) {
    return plan_of(spec, files, Precision::mixed, "start.xyz");
}

}  // namespace

TEST_CASE("the plan of a specification is the plan that its deck makes") {
    const FluidSpec spec = small_spec();
    const RunPlan plan = planned(spec, {.title = "small", .trajectory = TrajectoryOutput{.every = 7}});
    Diagnostics diagnostics;
    const auto deck = load_deck_text("deck", plan.source, {}, true, diagnostics);
    REQUIRE(deck.has_value());
    CHECK(deck->stages() == plan.stages());
    CHECK(plan.stages() == resolved_stages(spec));
    CHECK(deck->sample_every() == plan.sample_every());
    CHECK(deck->title == plan.title);
    CHECK(deck->trajectory->every == 7);
    CHECK(plan.trajectory->every == 7);
    CHECK(deck->precision == plan.precision);
    CHECK(plan.precision == Precision::mixed);
}

TEST_CASE("the deck of a stage at constant energy names no temperature, and the plan has none to hold") {
    FluidSpec spec = small_spec();
    spec.stages.push_back({.name = "kept", .steps = 10, .sample = true, .total_energy = -3.0});
    const RunPlan plan = planned(spec);
    CHECK(plan.source.find("temperature", plan.source.find("\"kept\"")) == std::string::npos);
    Diagnostics diagnostics;
    const auto deck = load_deck_text("deck", plan.source, {}, true, diagnostics);
    REQUIRE(deck.has_value());
    CHECK(deck->stages() == plan.stages());
}

TEST_CASE("Lennard-Jones stands in for a formula of the program, with a word about it") {
    FluidSpec spec = small_spec();
    spec.potential = PairPotential::custom("soft",
                                           [](const PairDistance<double>&) {
                                               return PairTerm<double>{0.0, 0.0};
                                           },
                                           "shifted", {1.5, 0.0});
    const RunPlan plan = plan_of(spec, {}, Precision::double_precision, "start.xyz");
    CHECK_THAT(plan.source, Contains("# The pair potential is") && Contains("type = \"lennard-jones\""));
    CHECK_FALSE(std::get<FluidSpec>(plan.spec).potential.is_custom());
    CHECK(std::get<FluidSpec>(plan.spec).potential.cutoff().radius == spec.potential.cutoff().radius);
}

TEST_CASE("files that cannot be are mistakes of the plan") {
    CHECK_THROWS_WITH(planned(small_spec(), {.trajectory = TrajectoryOutput{.every = 0}}),
                      Contains("'every' in trajectory is 0"));
    CHECK_THROWS_WITH(planned(small_spec(), {.checkpoint = {.every = {.steps = 5, .seconds = 5.0}}}),
                      Contains("'every' is a number of steps or of seconds"));
    CHECK_THROWS_AS(planned(FluidSpec()), InputError);
}
