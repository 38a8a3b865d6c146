#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "neighbors/sample_states.hpp"
#include "observables/analyses/made_analysis.hpp"

using namespace ljmd;

namespace {

DataTable rdf_of(const State& state, const test::AnalysisSettings& settings) {
    const AnalysisMethod method = test::analysis_method("rdf");
    const auto analysis = test::analysis_options(method, settings)->make(test::run_of(state));
    analysis->sample(state, {});
    return analysis->tables().at(0);
}

double radius_of(const DataTable& table) {
    return table.rows.back()[0] + table.rows.front()[0];  // middle of the last bin and half a bin
}

}  // namespace

TEST_CASE("rdf has 250 bins up to 5 sigma or L/2, whichever is smaller, unless told otherwise") {
    const State small = test::random_state(20, Box(Vec3(6.0, 7.0, 8.0)), 1);
    const State large = test::random_state(20, Box(Vec3::Constant(12.0)), 1);
    CHECK(rdf_of(small, {}).rows.size() == 250);
    CHECK(radius_of(rdf_of(small, {})) == Approx(3.0));
    CHECK(radius_of(rdf_of(large, {})) == Approx(5.0));
    const DataTable table = rdf_of(large, {{"bins", std::int64_t{60}}, {"radius", 6.0}});
    CHECK(table.rows.size() == 60);
    CHECK(radius_of(table) == Approx(6.0));
}

TEST_CASE("rdf is sampled every 200 steps unless told otherwise") {
    const State state = test::random_state(20, Box(Vec3::Constant(6.0)), 1);
    const AnalysisMethod method = test::analysis_method("rdf");
    const auto usual = test::analysis_options(method, {})->make(test::run_of(state));
    CHECK(usual->due(400));
    CHECK_FALSE(usual->due(100));
    const auto often = test::analysis_options(method, {{"every", std::int64_t{10}}})->make(test::run_of(state));
    CHECK(often->due(110));
    CHECK_FALSE(often->due(115));
}

TEST_CASE("a radius beyond L/2 is a mistake, L/2 is not") {
    const AnalysisMethod method = test::analysis_method("rdf");
    const SampledRun run{20, Box(Vec3(6.0, 7.0, 8.0)), 0.004, 1000, 1, std::nullopt, std::nullopt};
    CHECK(test::analysis_options(method, {})->check(run).empty());
    CHECK(test::analysis_options(method, {{"radius", 3.0}})->check(run).empty());
    const auto mistakes = test::analysis_options(method, {{"radius", 3.01}})->check(run);
    REQUIRE(mistakes.size() == 1);
    CHECK(mistakes[0].first == "radius");
    CHECK_THAT(mistakes[0].second, Catch::Contains("3.01") && Catch::Contains("3"));
}

TEST_CASE("values that make no distribution are refused") {
    const AnalysisMethod method = test::analysis_method("rdf");
    CHECK_THROWS_AS(test::analysis_section(method, {{"bins", std::int64_t{0}}}), InputError);
    CHECK_THROWS_AS(test::analysis_section(method, {{"radius", 0.0}}), InputError);
    CHECK_THROWS_AS(test::analysis_section(method, {{"every", std::int64_t{0}}}), InputError);
}
