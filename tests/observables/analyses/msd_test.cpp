#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "neighbors/sample_states.hpp"
#include "observables/analyses/made_analysis.hpp"

using namespace ljmd;

namespace {

/// Two atoms that fly apart, each straight on with velocity 1, as `msd` sees them.
std::unique_ptr<Analysis> flight(const test::AnalysisSettings& settings, Index every) {
    State state = test::random_state(2, Box(Vec3::Constant(6.0)), 1);
    const AnalysisMethod method = test::analysis_method("msd");
    const SampledRun run = test::run_of(state);  // 10000 steps of 0.004 tau
    auto analysis = test::analysis_options(method, settings)->make(run);
    const Eigen::Matrix3Xd begin = static_cast<const State&>(state).positions();
    for (Index step = 0; step <= run.steps; step += every) {
        CHECK(analysis->due(step));
        const Vec3 way(0.004 * static_cast<double>(step), 0.0, 0.0);
        state.write_positions().col(0) = begin.col(0) + way;
        state.write_positions().col(1) = begin.col(1) - way;
        analysis->sample(state, {});
    }
    return analysis;
}

double slope(const std::unique_ptr<Analysis>& analysis) {
    return 6.0 * analysis->observables().at(0).estimate->mean;
}

}  // namespace

TEST_CASE("msd goes every 50 steps up to a fifth of the stage, and fits from a fifth of that on") {
    const auto analysis = flight({}, 50);
    CHECK_FALSE(analysis->due(51));
    const DataTable table = analysis->tables().at(0);
    CHECK(table.rows.size() == 41);  // 8 tau in steps of 0.2
    CHECK(table.rows.back()[0] == Approx(8.0));
    // The slope of t^2 between t1 and t2 is t1 + t2.
    CHECK(slope(analysis) == Approx(1.6 + 8.0).epsilon(1e-9));
    CHECK(slope(flight({{"fit_start", 4.0}}, 50)) == Approx(12.0).epsilon(1e-9));
    CHECK(slope(flight({{"max_time", 2.0}}, 50)) == Approx(0.4 + 2.0).epsilon(1e-9));
    CHECK(slope(flight({{"max_time", 2.0}, {"every", std::int64_t{100}}, {"fit_start", 0.0}}, 100)) ==
          Approx(2.0).epsilon(1e-9));
}

TEST_CASE("a fit that begins at the last time is a mistake") {
    const State state = test::random_state(20, Box(Vec3::Constant(6.0)), 1);
    const AnalysisMethod method = test::analysis_method("msd");
    const auto mistakes = [&](const test::AnalysisSettings& settings) {
        return test::analysis_options(method, settings)->check(test::run_of(state));
    };
    CHECK(mistakes({}).empty());
    CHECK(mistakes({{"fit_start", 7.8}}).empty());
    REQUIRE(mistakes({{"fit_start", 8.0}}).size() == 1);
    CHECK(mistakes({{"fit_start", 8.0}})[0].first == "fit_start");
    CHECK_THAT(mistakes({{"fit_start", 8.0}})[0].second, Catch::Contains("at most 7.8"));
    REQUIRE(mistakes({{"max_time", 41.0}}).size() == 1);
    CHECK(mistakes({{"max_time", 41.0}})[0].first == "max_time");
    CHECK_THROWS_AS(test::analysis_section(method, {{"origins", std::int64_t{0}}}), InputError);
    CHECK_THROWS_AS(test::analysis_section(method, {{"fit_start", -1.0}}), InputError);
}
