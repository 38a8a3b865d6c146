#include "catch.hpp"

#include <numbers>
#include <set>

#include "ljmd/core/errors.hpp"
#include "neighbors/sample_states.hpp"
#include "observables/analyses/made_analysis.hpp"

using namespace ljmd;

namespace {

const Box cube(Vec3::Constant(6.0));

std::vector<DataTable> tables_of(const test::AnalysisSettings& settings) {
    const State state = test::random_state(20, cube, 1);
    const auto analysis =
        test::analysis_options(test::analysis_method("scattering"), settings)->make(test::run_of(state));
    CHECK_FALSE(analysis->needs_energy());
    for (Index frame = 0; frame < 250; ++frame) {
        analysis->sample(state, {});
    }
    return analysis->tables();
}

std::vector<double> different(const DataTable& table, std::size_t column) {
    std::set<double> found;
    for (const auto& row : table.rows) {
        found.insert(row[column]);
    }
    return {found.begin(), found.end()};
}

}  // namespace

TEST_CASE("scattering has seven wave numbers up to 7/sigma, every 10 steps up to 4 tau, unless told otherwise") {
    const auto usual = tables_of({});
    REQUIRE(usual.size() == 4);
    CHECK(usual[0].name == "fkt");
    CHECK(usual[1].name == "fskt");
    CHECK(usual[2].name == "skw");
    const auto k = different(usual[0], 0);
    REQUIRE(k.size() == 7);
    CHECK(k.front() == Approx(2.0 * std::numbers::pi / 6.0));
    CHECK(std::abs(k.back() - 7.0) < 0.3);
    CHECK(different(usual[0], 1).back() == Approx(4.0));
    const auto others = tables_of({{"k_min", 2.0}, {"k_max", 4.0}, {"shells", std::int64_t{2}}, {"max_time", 1.0}});
    CHECK(different(others[1], 0).size() == 2);
    CHECK(std::abs(different(others[1], 0).front() - 2.0) < 0.3);
    CHECK(different(others[1], 1).back() == Approx(1.0));
}

TEST_CASE("wave numbers below those of the box, and times beyond the run, are mistakes") {
    const State state = test::random_state(20, cube, 1);
    const AnalysisMethod method = test::analysis_method("scattering");
    const SampledRun run = test::run_of(state);
    CHECK(method.follows_time);
    CHECK(test::analysis_options(method, {})->check(run).empty());
    CHECK(test::analysis_options(method, {{"k_max", 1.0}})->check(run).at(0).first == "k_max");
    CHECK(test::analysis_options(method, {{"k_min", 3.0}, {"k_max", 2.0}})->check(run).at(0).first == "k_max");
    CHECK(test::analysis_options(method, {{"max_time", 41.0}})->check(run).at(0).first == "max_time");
    CHECK_THROWS_AS(test::analysis_section(method, {{"shells", std::int64_t{0}}}), InputError);
}
