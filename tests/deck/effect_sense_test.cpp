#include "deck/effect_sense.hpp"

#include "deck/deck_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

/// A deck that gives something in vain, the line that is pointed at and part of what is said.
struct Vain {
    std::string deck;
    Replacements replacements;
    std::string line;
    std::string message;
    std::vector<std::string> settings = {};
};

void check_told(const std::vector<Vain>& all) {
    for (const Vain& vain : all) {
        INFO(vain.line << " -> " << vain.message);
        const auto found = complaints(changed(vain.deck, vain.replacements), vain.settings);
        REQUIRE(found.size() == 1);
        INFO(format(found[0]));
        CHECK(found[0].severity == Severity::warning);
        CHECK(line_shown(found[0]) == vain.line);
        CHECK_THAT(found[0].message, Contains(vain.message));
    }
}

const std::string sampled = "sample = true\n";
const std::string output = "\n[output]\n";
const std::string analysis = "\n[analysis]\n";
const std::string rescaling = "thermostat = { type = \"rescale\", every = 5 }";
/// The first of the two stars alone.
const std::string comet =
    stars_deck.substr(0, stars_deck.rfind("[[body]]")) + stars_deck.substr(stars_deck.find("[[stage]]"));

}  // namespace

TEST_CASE("keys of a fluid that have no effect are told of, each at its place") {
    check_told({
        {small_deck,
         {{sampled, sampled + "temperature = 2.0\n"}},
         "temperature = 2.0",
         "no effect without a thermostat"},
        {small_deck,
         {{sampled, sampled + "[neighbors]\nmethod = \"cells\"\nskin = 0.3\n"}},
         "skin = 0.3",
         "'skin' in [neighbors] has no effect with method = \"cells\""},
        {small_deck,
         {},
         "--set neighbors={ method = \"all-pairs\", skin = 0.4 }",
         "no effect with method",
         {"neighbors={ method = \"all-pairs\", skin = 0.4 }"}},
        {small_deck,
         {{rescaling, "thermostat = { type = \"rescale\", every = 21 }"}},
         "thermostat = { type = \"rescale\", every = 21 }",
         "the thermostat of stage 'equilibrate' never acts"},
        {small_deck,
         {{rescaling,
           "thermostat = { type = \"langevin\" }\nbarostat = { type = \"stochastic-cell-rescaling\", "
           "pressure = 1.0, every = 30 }"}},
         "barostat = { type = \"stochastic-cell-rescaling\", pressure = 1.0, every = 30 }",
         "the barostat of stage 'equilibrate' never acts: it does so every 30 steps, and the stage has 20"},
        {small_deck + output + "trajectory = { every = 61 }\n",
         {},
         "trajectory = { every = 61 }",
         "the trajectory will hold the start alone: its frames come every 61 steps, and the run has 60"},
    });
    CHECK(complaints(small_deck + output + "trajectory = { every = 60 }\n").empty());
    CHECK(complaints(changed(small_deck, {{"every = 5", "every = 20"}})).empty());
    CHECK(complaints(small_deck, {"neighbors.method=cells"}).empty());
}

TEST_CASE("a deck that measures nothing is told of") {
    check_told({
        {small_deck, {{sampled, ""}}, "[[stage]]", "no stage is sampled: there will be no averages"},
        {small_deck + analysis + "rdf = { every = 5 }\n",
         {{sampled, ""}},
         "[[stage]]",
         "no averages, and nothing of what [analysis] asks for"},
        {small_deck + output + "thermo = { every = 61 }\n",
         {},
         "sample = true",
         "stage 'production' adds nothing to the averages: samples are the rows of thermo.csv, every 61 steps of the "
         "run"},
        {small_deck,
         {},
         "sample = true",
         "none falls into its 5 steps",
         {"stage.production.steps=5", "output.thermo.every=20", "stage.equilibrate.steps=20"}},
        {small_deck, {}, "sample = true", "none falls into its 0 steps", {"stage.production.steps=0"}},
        {small_deck + analysis + "rdf = { every = 61 }\n",
         {},
         "rdf = { every = 61 }",
         "'rdf' in [analysis] measures nothing: it looks every 61 steps of the run"},
        {small_deck + analysis + "rdf = {}\n",
         {},
         "rdf = {}",
         "'rdf' in [analysis] measures nothing: it looks every 200"},
    });
    // Rows and looks count the steps of the run: step 60 is in the sampled stage, though that has only 40.
    CHECK(complaints(small_deck + output + "thermo = { every = 60 }\n" + analysis + "rdf = { every = 60 }\n").empty());
    // A deck of no steps at all measures its start.
    CHECK(complaints(changed(small_deck, {{sampled, ""}}), {"stage.equilibrate.steps=0", "stage.production.steps=0"})
              .empty());
}

TEST_CASE("keys of few bodies that have no effect are told of") {
    const std::string stage = "steps = 95\n";
    check_told({
        {stars_deck, {{stage, stage + "sample = true\n"}}, "sample = true", "no effect without [analysis]"},
        {stars_deck + analysis + "closest_approach = {}\n",
         {{stage, stage + "sample = false\n"}},
         "[[stage]]",
         "no stage is sampled: nothing of what [analysis] asks for"},
        {stars_deck,
         {},
         "--set output.trajectory={ every = 5, velocities = false }",
         "csv\" always has them",
         {"output.trajectory={ every = 5, velocities = false }"}},
        {stars_deck, {}, "--set output.trajectory.every=96", "the start alone", {"output.trajectory.every=96"}},
        {comet, {}, "gravitational_constant = 1.0", "no effect on a single body without 'central_mass'"},
    });
    CHECK(complaints(stars_deck + analysis + "closest_approach = {}\n").empty());
    CHECK(complaints(comet, {"force.central_mass=1.0"}).empty());
    CHECK(complaints(stars_deck, {"output.trajectory={ every = 5, format = \"h5md\", velocities = false }"}).empty());
    CHECK(complaints(radial_deck).empty());
}
