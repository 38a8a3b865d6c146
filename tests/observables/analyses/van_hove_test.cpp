#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "neighbors/sample_states.hpp"
#include "observables/analyses/made_analysis.hpp"

using namespace ljmd;

namespace {

std::vector<DataTable> distributions_of(const test::AnalysisSettings& settings) {
    const State state = test::random_state(20, Box(Vec3::Constant(6.0)), 1);
    const auto analysis =
        test::analysis_options(test::analysis_method("van_hove"), settings)->make(test::run_of(state));
    CHECK_FALSE(analysis->needs_energy());
    for (Index frame = 0; frame < 110; ++frame) {
        analysis->sample(state, {});
    }
    return analysis->tables();
}

}  // namespace

TEST_CASE("van_hove has ten times up to 4 tau and 100 bins up to 3 sigma, every 10 steps, unless told otherwise") {
    const auto usual = distributions_of({});
    REQUIRE(usual.size() == 2);
    CHECK(usual[0].name == "alpha2");
    CHECK(usual[0].rows.back()[0] == Approx(4.0));
    CHECK(usual[1].name == "gs");
    REQUIRE(usual[1].rows.size() == 1000);
    CHECK(usual[1].rows.front()[0] == Approx(0.4));
    CHECK(usual[1].rows.back()[0] == Approx(4.0));
    CHECK(usual[1].rows.back()[1] == Approx(2.985));
    // Atoms at rest stay in the first bin.
    CHECK(usual[1].rows[0][2] * 4.0 / 3.0 * 3.14159265358979 * 0.03 * 0.03 * 0.03 == Approx(1.0));
    CHECK(usual[1].rows[1][2] == 0.0);
    const auto others =
        distributions_of({{"times", std::int64_t{50}}, {"bins", std::int64_t{8}}, {"radius", 2.0}, {"max_time", 1.0}});
    CHECK(others[1].rows.size() == 25 * 8);  // as many times as there are
    CHECK(others[1].rows.back()[1] == Approx(1.875));
}

TEST_CASE("times beyond the run and bins of no width are mistakes") {
    const State state = test::random_state(20, Box(Vec3::Constant(6.0)), 1);
    const AnalysisMethod method = test::analysis_method("van_hove");
    CHECK(method.follows_time);
    CHECK(test::analysis_options(method, {{"max_time", 41.0}})->check(test::run_of(state)).at(0).first == "max_time");
    CHECK_THROWS_AS(test::analysis_section(method, {{"radius", 0.0}}), InputError);
    CHECK_THROWS_AS(test::analysis_section(method, {{"bins", std::int64_t{0}}}), InputError);
}
