#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "neighbors/sample_states.hpp"
#include "observables/analyses/made_analysis.hpp"

using namespace ljmd;

TEST_CASE("configurational_temperature looks every 100 steps, with energies, in any box, unless told otherwise") {
    const State state = test::random_state(20, Box(Vec3::Constant(6.0)), 1);
    const AnalysisMethod method = test::analysis_method("configurational_temperature");
    const SampledRun run = test::run_of(state);
    const auto analysis = test::analysis_options(method)->make(run);
    CHECK(analysis->due(200));
    CHECK_FALSE(analysis->due(50));
    CHECK(analysis->needs_energy());
    CHECK_FALSE(method.follows_time);
    CHECK(method.needs.interaction);
    CHECK_FALSE(method.needs.fixed_box);
    CHECK(test::analysis_options(method, {{"every", std::int64_t{3}}})->make(run)->due(3));
    CHECK_THROWS_AS(test::analysis_section(method, {{"every", std::int64_t{0}}}), InputError);
}
