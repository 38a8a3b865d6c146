#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "neighbors/sample_states.hpp"
#include "observables/analyses/made_analysis.hpp"

using namespace ljmd;

namespace {

DataTable sk_of(const State& state, const test::AnalysisSettings& settings) {
    const AnalysisMethod method = test::analysis_method("structure_factor");
    const auto analysis = test::analysis_options(method, settings)->make(test::run_of(state));
    CHECK(analysis->due(1000));
    CHECK_FALSE(analysis->due(500));
    analysis->sample(state, {});
    return analysis->tables().at(0);
}

std::string mistake(const Box& box, const test::AnalysisSettings& settings) {
    const AnalysisMethod method = test::analysis_method("structure_factor");
    const State state = test::random_state(1, box, 1);
    const auto mistakes = test::analysis_options(method, settings)->check(test::run_of(state));
    return mistakes.empty() ? "" : mistakes.at(0).first + ": " + mistakes.at(0).second;
}

}  // namespace

TEST_CASE(
    "structure_factor goes up to 15/sigma in shells of 0.1, by the grid, every 1000 steps, unless told otherwise") {
    const State state = test::random_state(20, Box(Vec3::Constant(5.0)), 1);
    const DataTable usual = sk_of(state, {});
    CHECK(usual.rows.back()[0] > 14.9);
    CHECK(usual.rows.back()[0] <= 15.0);
    const DataTable direct = sk_of(state, {{"method", "direct"}});
    REQUIRE(direct.rows.size() == usual.rows.size());
    for (std::size_t k = 0; k < direct.rows.size(); ++k) {
        CHECK(usual.rows[k][1] == Approx(direct.rows[k][1]).epsilon(1e-9));
    }
    CHECK(direct.rows != usual.rows);  // they were computed in two ways
    CHECK(sk_of(state, {{"k_max", 4.0}}).rows.back()[0] <= 4.0);
    CHECK(sk_of(state, {{"width", 1.0}}).rows.size() <= 15);
}

TEST_CASE("wave numbers that the box does not allow, and grids that no memory holds, are mistakes") {
    CHECK(mistake(Box(Vec3::Constant(5.0)), {}).empty());
    CHECK_THAT(mistake(Box(Vec3::Constant(5.0)), {{"k_max", 1.2}}),
               Catch::Contains("k_max") && Catch::Contains("allows is 1.25664"));
    CHECK(mistake(Box(Vec3(5.0, 5.0, 6.0)), {{"k_max", 1.2}}).empty());
    CHECK_THAT(mistake(Box(Vec3::Constant(200.0)), {}), Catch::Contains("its grid would have"));
    CHECK(mistake(Box(Vec3::Constant(200.0)), {{"k_max", 5.0}}).empty());
    CHECK(mistake(Box(Vec3::Constant(200.0)), {{"method", "direct"}}).empty());
    CHECK_THROWS_AS(test::analysis_section(test::analysis_method("structure_factor"), {{"method", "quick"}}),
                    InputError);
}
