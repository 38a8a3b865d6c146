#include "engine/mistakes/film_mistakes.hpp"

#include "catch.hpp"

#include "engine/engine_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

Mistake the_one(const std::vector<Mistake>& found) {
    REQUIRE(found.size() == 1);
    return found.front();
}

LatticeStart film_of_height(std::optional<double> height) {
    return {.lattice = Lattice::fcc, .cells = 3, .layers = 6, .height = height};
}

}  // namespace

TEST_CASE("a film is not higher than its box, and has no tail correction") {
    const LatticeStart film = film_of_height(10.26);
    CHECK(film_mistakes(film, 0.8, false).empty());
    CHECK(film_mistakes({.cells = 3}, 0.8, true).empty());
    CHECK(in_words(the_one(film_mistakes(film, 0.79, false))) ==
          "start: lattice.height is 10.26, but the crystal is 10.303 sigma high");
    CHECK(the_one(film_mistakes(film, 0.8, true)).keys == std::vector<std::string>{"tail"});
}

TEST_CASE("a film is a crystal in a box that is higher than it") {
    const double crystal = crystal_edges(Lattice::fcc, 3, 6, 0.8).z();
    CHECK_FALSE(is_film(film_of_height(std::nullopt), 0.8));
    CHECK_FALSE(is_film(film_of_height(crystal), 0.8));
    CHECK(is_film(film_of_height(1.01 * crystal), 0.8));
    FluidSpec spec = small_spec();
    CHECK_FALSE(is_film(spec));
    spec.density = 0.8;
    spec.start = film_of_height(20.0);
    CHECK(is_film(spec));
    spec.start = RandomStart{.atoms = 108};
    CHECK_FALSE(is_film(spec));
}

TEST_CASE("a film has no analysis that is for a homogeneous fluid") {
    const std::vector<std::string> homogeneous{"viscosity", "bulk_viscosity", "thermal_conductivity",
                                               "cutoff_correction", "response_functions"};
    for (const AnalysisMethod& method : all_analyses()) {
        CAPTURE(method.name);
        const std::vector<Choice> alone{analysis(method.name)};
        const bool refused = std::ranges::find(homogeneous, method.name) != homogeneous.end();
        CHECK(homogeneity_mistakes(alone, true).size() == (refused ? 1 : 0));
        CHECK(homogeneity_mistakes(alone, false).empty());
    }
    const Mistake found = the_one(homogeneity_mistakes({analysis("viscosity")}, true));
    CHECK(in_words(found) ==
          "start: the analysis viscosity is for a homogeneous fluid, and a box that is higher than its crystal holds a "
          "film; leave one of the two out");

    FluidSpec spec = small_spec();
    spec.density = 0.8;
    spec.start = film_of_height(20.0);
    spec.analyses = {analysis("chemical_potential"), analysis("rdf")};
    CHECK(mistakes(spec).empty());
    spec.analyses.push_back(analysis("cutoff_correction"));
    REQUIRE(mistakes(spec).size() == 1);
    CHECK_THAT(mistakes(spec).front(), Contains("the analysis cutoff_correction is for a homogeneous fluid"));
}
