#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "neighbors/sample_states.hpp"
#include "observables/analyses/made_analysis.hpp"

using namespace ljmd;

TEST_CASE("vacf is sampled every 5 steps, up to 4 tau or a tenth of the stage") {
    const State state = test::random_state(20, Box(Vec3::Constant(6.0)), 1);
    const AnalysisMethod method = test::analysis_method("vacf");
    SampledRun run = test::run_of(state);  // 40 tau: a tenth of it is 4
    const auto largest_time = [&](const test::AnalysisSettings& settings) {
        const auto analysis = test::analysis_options(method, settings)->make(run);
        Index steps = 0;
        while (analysis->tables().empty() && steps < 10 * run.steps) {
            steps += analysis->due(steps + 1) ? 1 : 0;
            analysis->sample(state, {});
            ++steps;
        }
        return analysis->tables().at(0).rows.back()[0];
    };
    const auto analysis = test::analysis_options(method, {})->make(run);
    CHECK(analysis->due(5));
    CHECK_FALSE(analysis->due(6));
    CHECK_FALSE(analysis->needs_energy());
    CHECK(method.follows_time);
    CHECK(largest_time({}) == Approx(4.0));
    CHECK(largest_time({{"max_time", 1.0}}) == Approx(1.0));
    CHECK(largest_time({{"max_time", 1.0}, {"every", std::int64_t{20}}}) == Approx(0.96));  // 12 times 0.08
    run.steps = 1000;
    CHECK(largest_time({}) == Approx(0.4));
}

TEST_CASE("velocities that no two of are so far apart are a mistake") {
    const State state = test::random_state(20, Box(Vec3::Constant(6.0)), 1);
    const AnalysisMethod method = test::analysis_method("vacf");
    const SampledRun run = test::run_of(state);
    CHECK(test::analysis_options(method, {{"max_time", 40.0}})->check(run).empty());
    REQUIRE(test::analysis_options(method, {{"max_time", 41.0}})->check(run).size() == 1);
    REQUIRE(test::analysis_options(method, {{"max_time", 0.01}})->check(run).size() == 1);
    CHECK_THROWS_AS(test::analysis_section(method, {{"max_time", 0.0}}), InputError);
}
