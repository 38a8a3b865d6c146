#include "deck/phase_sense.hpp"

#include "deck/deck_fixtures.hpp"
#include "deck/start_sense.hpp"
#include "io/formats/extended_xyz_writer.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

/// What loading a deck says, whose fluid is at this state.
std::vector<Diagnostic> said_at(double density, double temperature, const std::vector<std::string>& more = {}) {
    std::vector<std::string> settings{"system.density=" + std::to_string(density),
                                      "system.temperature=" + std::to_string(temperature)};
    settings.insert(settings.end(), more.begin(), more.end());
    const DeckFolder folder(small_deck);
    Diagnostics diagnostics;
    REQUIRE(load_deck(folder.deck_path(), settings, false, diagnostics));
    return diagnostics.entries();
}

}  // namespace

TEST_CASE("a deck whose fluid is beyond its freezing density is warned of") {
    CHECK(said_at(0.85, 0.722).empty());
    const auto between = said_at(0.9, 0.722);
    REQUIRE(between.size() == 1);
    CHECK(between[0].severity == Severity::warning);
    CHECK(line_shown(between[0]) == "--set system.density=0.900000");
    CHECK_THAT(between[0].message,
               Contains("the density is 0.9: at temperature 0.722 the fluid of the full "
                        "Lennard-Jones potential freezes at 0.8545, and its crystal melts at 0.9648"));
    CHECK_THAT(between[0].hint, Contains("coexist"));
    const auto above = said_at(1.0, 0.722);
    REQUIRE(above.size() == 1);
    CHECK_THAT(above[0].hint, Contains("the crystal is stable here"));
    CHECK(said_at(1.0, 0.722, {"analysis.crystal.every=10"}).empty());  // the crystal is wanted
    CHECK(said_at(0.9, 0.722, {"analysis.crystal.every=10"}).size() == 1);
    CHECK(said_at(1.0, 3.0).empty());
}

TEST_CASE("where freezing is not known, or the density is not held, nothing is said") {
    CHECK(said_at(0.9, 0.69).empty());  // below the triple point
    CHECK(said_at(
              0.9, 0.722,
              {"potential.type=morse", "potential.well_depth=1.0", "potential.steepness=6.0", "potential.minimum=1.12"})
              .empty());
    CHECK(said_at(0.9, 0.722,
                  {"stage.equilibrate.thermostat={ type = \"stochastic-rescaling\" }",
                   "stage.equilibrate.barostat={ type = \"stochastic-cell-rescaling\", pressure = 1.0 }"})
              .empty());
}

TEST_CASE("the density of a file that a run starts from is looked at, too") {
    const DeckFolder crystal(changed(small_deck, {{"density = 0.8\n", "density = 0.95\n"}}));
    write_configuration(crystal / "start.xyz", simulation_of(crystal.load()).state, true);
    const DeckFolder folder(changed(small_deck, {{"lattice = { type = \"fcc\", cells = 3 }\ndensity = 0.8\n", ""}}));
    Diagnostics diagnostics;
    const auto deck =
        load_deck(folder.deck_path(), {"system.file=" + (crystal / "start.xyz").string(), "system.temperature=0.722"},
                  false, diagnostics);
    REQUIRE(deck);
    REQUIRE(diagnostics.entries().empty());
    check_start(*deck, find_start(*deck), diagnostics);
    REQUIRE_FALSE(diagnostics.entries().empty());
    CHECK_THAT(diagnostics.entries().back().message, Contains("the density is 0.95: at temperature 0.722"));
}
