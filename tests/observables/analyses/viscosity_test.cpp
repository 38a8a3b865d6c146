#include "catch.hpp"

#include "neighbors/sample_states.hpp"
#include "observables/analyses/made_analysis.hpp"

using namespace ljmd;

TEST_CASE("viscosity asks for the virial of every fifth step, up to 5 tau or a twentieth of the stage") {
    const State state = test::random_state(20, Box(Vec3::Constant(6.0)), 1);
    const AnalysisMethod method = test::analysis_method("viscosity");
    const SampledRun run = test::run_of(state);  // 40 tau: a twentieth of it is 2
    const auto analysis = test::analysis_options(method, {})->make(run);
    CHECK(analysis->needs_energy());
    CHECK(method.follows_time);
    CHECK(analysis->due(5));
    CHECK_FALSE(analysis->due(6));
    for (int k = 0; k < 200; ++k) {  // a window is twice the largest time of 100 configurations
        CHECK(analysis->tables().empty());
        analysis->sample(state, {});
    }
    REQUIRE(analysis->tables().size() == 1);
    CHECK(analysis->tables().at(0).rows.back()[0] == Approx(2.0));
}

TEST_CASE("stresses that no two of are so far apart are a mistake") {
    const State state = test::random_state(20, Box(Vec3::Constant(6.0)), 1);
    const AnalysisMethod method = test::analysis_method("viscosity");
    const auto mistakes = test::analysis_options(method, {{"max_time", 41.0}})->check(test::run_of(state));
    REQUIRE(mistakes.size() == 1);
    CHECK(mistakes[0].first == "max_time");
    CHECK_THAT(mistakes[0].second, Catch::Contains("in viscosity is 41"));
}
