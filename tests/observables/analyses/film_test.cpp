#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "neighbors/sample_states.hpp"
#include "observables/analyses/made_analysis.hpp"

using namespace ljmd;

TEST_CASE("a film has 200 layers along z and is measured every 50 steps unless told otherwise") {
    const State state = test::random_state(20, Box(Vec3(6.0, 7.0, 30.0)), 1);
    const AnalysisMethod method = test::analysis_method("film");
    const auto usual = test::analysis_options(method)->make(test::run_of(state));
    CHECK(usual->due(150));
    CHECK_FALSE(usual->due(75));
    usual->sample(state, {});
    CHECK(usual->tables().at(0).rows.size() == 200);
    CHECK(usual->tables().at(0).rows.back()[0] == Approx(15.0 - 0.075));
    const auto along_x =
        test::analysis_options(method, {{"axis", "x"}, {"layers", std::int64_t{6}}})->make(test::run_of(state));
    along_x->sample(state, {});
    CHECK(along_x->tables().at(0).rows.back()[0] == Approx(2.5));
}

TEST_CASE("an odd number of layers is a mistake, and so is an edge that does not exist") {
    const AnalysisMethod method = test::analysis_method("film");
    const State state = test::random_state(20, Box(Vec3(6.0, 7.0, 30.0)), 1);
    const auto mistakes = test::analysis_options(method, {{"layers", std::int64_t{7}}})->check(test::run_of(state));
    REQUIRE(mistakes.size() == 1);
    CHECK(mistakes[0].first == "layers");
    CHECK_THAT(mistakes[0].second, Catch::Contains("7") && Catch::Contains("even"));
    CHECK_THROWS_AS(test::analysis_section(method, {{"axis", "w"}}), InputError);
}
