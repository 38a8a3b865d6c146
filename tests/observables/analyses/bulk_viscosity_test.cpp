#include "catch.hpp"

#include "neighbors/sample_states.hpp"
#include "observables/analyses/made_analysis.hpp"

using namespace ljmd;

TEST_CASE("bulk viscosity needs constant energy and stages of ten times the largest time") {
    const State state = test::random_state(20, Box(Vec3::Constant(6.0)), 1);
    const AnalysisMethod method = test::analysis_method("bulk_viscosity");
    CHECK(method.follows_time);
    CHECK(method.needs.continuous_potential);
    CHECK(method.needs.constant_energy);
    const SampledRun run = test::run_of(state);  // 40 tau
    const auto analysis = test::analysis_options(method, {})->make(run);
    CHECK(analysis->needs_energy());
    CHECK(analysis->due(5));
    CHECK_FALSE(analysis->due(6));
    CHECK(test::analysis_options(method, {{"max_time", 4.0}})->check(run).empty());
    const auto mistakes = test::analysis_options(method, {{"max_time", 4.1}})->check(run);
    REQUIRE(mistakes.size() == 1);
    CHECK(mistakes[0].first == "max_time");
    CHECK_THAT(mistakes[0].second, Catch::Contains("'max_time' in bulk_viscosity is 4.1") &&
                                       Catch::Contains("10 times as long") && Catch::Contains("40 tau"));
    CHECK(test::analysis_options(method, {{"max_time", 41.0}})->check(run).size() == 1);
}
