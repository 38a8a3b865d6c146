#include "catch.hpp"

#include "neighbors/sample_states.hpp"
#include "observables/analyses/made_analysis.hpp"

using namespace ljmd;

TEST_CASE("a crystal is a cube of all atoms unless told otherwise, with six families every 50 steps") {
    const AnalysisMethod method = test::analysis_method("crystal");
    const State cube = test::crystal_state(Lattice::fcc, 3, Box(Vec3(4.8, 4.8, 4.8)));
    const auto usual = test::analysis_options(method);
    CHECK(usual->check(test::run_of(cube)).empty());
    const auto analysis = usual->make(test::run_of(cube));
    CHECK(analysis->due(150));
    CHECK_FALSE(analysis->due(75));
    analysis->sample(cube, {});
    CHECK(analysis->tables().at(0).rows.size() == 6);
    CHECK(analysis->observables().at(0).estimate.value().mean < 1e-24);

    const Box high(Vec3(3.2, 3.2, 8.0));
    const State column = test::state_of(lattice_sites(Lattice::fcc, 2, 5, high.edges(), high), high);
    const auto told = test::analysis_options(method, {{"cells", std::int64_t{2}}, {"layers", std::int64_t{5}}});
    CHECK(told->check(test::run_of(column)).empty());
    const auto of_column = told->make(test::run_of(column));
    of_column->sample(column, {});
    CHECK(of_column->observables().at(0).estimate.value().mean < 1e-24);
}

TEST_CASE("atoms that fill no cube need the cells, and layers alone are a mistake") {
    const AnalysisMethod method = test::analysis_method("crystal");
    const State state = test::random_state(107, Box(Vec3(6.0, 6.0, 6.0)), 1);
    const auto mistakes = test::analysis_options(method)->check(test::run_of(state));
    REQUIRE(mistakes.size() == 1);
    CHECK_THAT(mistakes[0].second, Catch::Contains("107 atoms") && Catch::Contains("'cells' is missing"));
    CHECK(test::analysis_options(method, {{"cells", std::int64_t{3}}})->check(test::run_of(state)).empty());
    const auto layers = test::analysis_options(method, {{"layers", std::int64_t{3}}})->check(test::run_of(state));
    REQUIRE(layers.size() == 1);
    CHECK(layers[0].first == "layers");
}
