#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "neighbors/sample_states.hpp"
#include "observables/analyses/made_analysis.hpp"

using namespace ljmd;

TEST_CASE("cutoff_correction looks every 200 steps, with energies, up to half the box") {
    const State state = test::random_state(20, Box(Vec3::Constant(6.0)), 1);
    const AnalysisMethod method = test::analysis_method("cutoff_correction");
    const SampledRun run = test::run_of(state);
    const auto analysis = test::analysis_options(method)->make(run);
    CHECK(analysis->due(400));
    CHECK_FALSE(analysis->due(100));
    CHECK(analysis->needs_energy());
    CHECK(method.needs.interaction);
    CHECK(method.needs.fixed_box);
    CHECK(test::analysis_options(method, {{"radius", 3.0}})->check(run).empty());
    const Misfits misfits = test::analysis_options(method, {{"radius", 3.01}})->check(run);
    REQUIRE(misfits.size() == 1);
    CHECK(misfits.front().first == "radius");
    CHECK_THROWS_AS(test::analysis_section(method, {{"radius", 0.0}}), InputError);
}
