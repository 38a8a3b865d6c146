#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "model/velocities.hpp"
#include "neighbors/sample_states.hpp"
#include "observables/analyses/made_analysis.hpp"
#include "observables/widom_insertion.hpp"

using namespace ljmd;

TEST_CASE("chemical_potential tries as many places as there are atoms, every 200 steps, unless told otherwise") {
    State state = test::random_state(40, Box(Vec3::Constant(6.0)), 1);
    draw_velocities(state, 2.0, 1);
    const AnalysisMethod method = test::analysis_method("chemical_potential");
    const SampledRun run = test::run_of(state);
    CHECK_FALSE(method.follows_time);
    CHECK(test::analysis_options(method, {})->check(run).empty());
    const auto found = [&](const test::AnalysisSettings& settings) {
        const auto analysis = test::analysis_options(method, settings)->make(run);
        CHECK(analysis->due(400));
        CHECK_FALSE(analysis->due(50));
        analysis->sample(state, {});
        CHECK(analysis->tables().empty());
        return analysis->observables().at(0).estimate->mean;
    };
    const auto expected = [&](Index insertions) {
        WidomInsertion widom(run, insertions, Every(1));
        widom.sample(state, {});
        return widom.observables().at(0).estimate->mean;
    };
    CHECK(found({}) == expected(40));
    CHECK(found({{"insertions", std::int64_t{7}}}) == expected(7));
    CHECK(expected(7) != expected(40));
    CHECK_THROWS_AS(test::analysis_section(method, {{"insertions", std::int64_t{0}}}), InputError);
}
