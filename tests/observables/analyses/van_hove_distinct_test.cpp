#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "neighbors/sample_states.hpp"
#include "observables/analyses/made_analysis.hpp"

using namespace ljmd;

TEST_CASE("van_hove_distinct measures five times up to 1 tau, from an origin every 16 tau, unless told otherwise") {
    const State state = test::random_state(20, Box(Vec3::Constant(6.0)), 1);
    const AnalysisMethod method = test::analysis_method("van_hove_distinct");
    const SampledRun run = test::run_of(state);
    const auto analysis = test::analysis_options(method, {})->make(run);
    CHECK(method.follows_time);
    CHECK_FALSE(analysis->needs_energy());
    CHECK(analysis->due(50));
    CHECK_FALSE(analysis->due(60));
    for (Index frame = 0; frame < 6; ++frame) {
        CHECK(analysis->tables().empty());
        analysis->sample(state, {});
    }
    const auto rows = analysis->tables().at(0).rows;
    REQUIRE(rows.size() == 600);
    CHECK(rows.back()[0] == Approx(1.0));
    CHECK(rows.back()[1] == Approx(2.985));  // L/2 is 3
}

TEST_CASE("distances beyond half of the box are a mistake of van_hove_distinct") {
    const State state = test::random_state(20, Box(Vec3::Constant(6.0)), 1);
    const AnalysisMethod method = test::analysis_method("van_hove_distinct");
    CHECK(test::analysis_options(method, {{"radius", 3.0}})->check(test::run_of(state)).empty());
    CHECK(test::analysis_options(method, {{"radius", 3.1}})->check(test::run_of(state)).at(0).first == "radius");
    CHECK_THROWS_AS(test::analysis_section(method, {{"between", 0.0}}), InputError);
}
