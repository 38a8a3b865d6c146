#include "catch.hpp"

#include "model/velocities.hpp"
#include "neighbors/sample_states.hpp"
#include "observables/analyses/made_analysis.hpp"

using namespace ljmd;

TEST_CASE("thermal conductivity samples every tenth step, up to 3 tau or a twentieth of the stage") {
    State state = test::shaken_crystal(3, 0.8, 0.2, 3);
    draw_velocities(state, 1.0, 5);
    const AnalysisMethod method = test::analysis_method("thermal_conductivity");
    CHECK(method.follows_time);
    CHECK(method.needs.continuous_potential);
    CHECK_FALSE(method.needs.constant_energy);
    const auto analysis = test::analysis_options(method, {})->make(test::run_of(state));  // 40 tau
    CHECK(analysis->due(10));
    CHECK_FALSE(analysis->due(5));
    for (int k = 0; k < 100; ++k) {
        CHECK(analysis->tables().empty());
        analysis->sample(state, {});
    }
    CHECK(analysis->tables().at(0).rows.back()[0] == Approx(2.0));
    const auto mistakes = test::analysis_options(method, {{"max_time", 41.0}})->check(test::run_of(state));
    REQUIRE(mistakes.size() == 1);
    CHECK_THAT(mistakes[0].second, Catch::Contains("in thermal_conductivity is 41"));
}
