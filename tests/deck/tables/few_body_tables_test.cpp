#include "deck/tables/few_body_tables.hpp"

#include "deck/deck_fixtures.hpp"
#include "forces/few_body_force.hpp"
#include "integrators/integrator.hpp"
#include "observables/few_body/few_body_analysis.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

/// The keys of a method, all with a value that every one allows.
std::string with_ones(const std::vector<Key>& keys, const std::string& separator) {
    std::string text;
    for (const Key& key : keys) {
        text += key.required ? separator + key.name + " = 1" : "";
    }
    return text;
}

const std::string gravity = "type = \"newtonian-gravity\"\ngravitational_constant = 1.0";
const std::string steps = "steps = 95";

void check_one(const Replacements& replacements, const std::string& message) {
    const std::string text = changed(stars_deck, replacements);
    INFO(text);
    const auto found = complaints(text);
    REQUIRE(found.size() == 1);
    CHECK_THAT(found[0].message, Contains(message));
}

}  // namespace

TEST_CASE("what a few-body deck leaves out has its default") {
    const Deck deck = DeckFolder(changed(stars_deck, {{"\n[output]\nthermo = { every = 10 }\n", ""}})).load();
    CHECK(!deck.is_fluid());
    CHECK(deck.sample_every() == 1);
    CHECK_FALSE(deck.trajectory.has_value());
    CHECK_FALSE(deck.units().has_value());
    REQUIRE(deck.stages().size() == 1);
    CHECK(deck.stages()[0].integrator.name == "velocity-verlet");
    CHECK(deck.stages()[0].sample);
    CHECK_FALSE(deck.stages()[0].reverse);
    CHECK(settings_in_words(deck.few_body().force.method.settings) ==
          "gravitational_constant=1 softening=0 central_mass=0");
    const Deck written = DeckFolder(stars_deck).load({"output.trajectory.every=7"});
    REQUIRE(written.trajectory.has_value());
    CHECK(written.trajectory->format == "csv");
    CHECK(written.trajectory->every == 7);
    CHECK_FALSE(written.trajectory->accelerations);
    CHECK_FALSE(written.trajectory->si());
}

TEST_CASE("every force, integrator and analysis of few bodies can be selected by its name") {
    for (const FewBodyForceMethod& method : all_few_body_forces()) {
        Replacements replacements{{gravity, "type = \"" + method.name + "\"" + with_ones(keys_of(method), "\n")}};
        if (method.max_dimensions == 1) {
            replacements.insert(
                replacements.end(),
                {{"[-0.5, 0.0]", "[0.5]"}, {"[0.0, -0.3]", "[0.3]"}, {"[0.5, 0.0]", "[0.5]"}, {"[0.0, 0.3]", "[0.3]"}});
        }
        const std::string text = changed(stars_deck, replacements);
        INFO(text);
        CHECK(complaints(text).empty());
    }
    for (const IntegratorMethod& method : all_integrators()) {
        INFO(method.name);
        CHECK(complaints(changed(stars_deck, {{steps, steps + "\nintegrator = \"" + method.name + "\""}})).empty());
    }
    for (const FewBodyAnalysisMethod& method : all_few_body_analyses()) {
        INFO(method.name);
        CHECK(complaints(stars_deck + "\n[analysis]\n" + method.name + " = {" + with_ones(keys_of(method), "") + "}\n")
                  .empty());
    }
}

TEST_CASE("values of bodies and stages that cannot be meant are refused at their key") {
    check_one({{"mass = 0.5", "mass = 0.0"}}, "'mass'");
    check_one({{"mass = 0.5", "mass = -1.0"}}, "'mass'");
    check_one({{"[-0.5, 0.0]", "[]"}}, "'position'");
    check_one({{"[-0.5, 0.0]", "[1, 2, 3, 4]"}}, "'position'");
    check_one({{"[-0.5, 0.0]", "[nan, 0.0]"}}, "'position'");
    check_one({{"[-0.5, 0.0]", "[1e200, 0.0]"}}, "'position'");
    check_one({{"[-0.5, 0.0]", "[\"left\", 0.0]"}}, "'position'");
    check_one({{"velocity = [0.0, -0.3]\n", ""}}, "'velocity'");
    check_one({{"time_step = 0.01", "time_step = 0.0"}}, "'time_step'");
    check_one({{"time_step = 0.01", "time_step = \"1 fs\""}}, "'time_step'");
    check_one({{steps, steps + "\nthermostat = { type = \"rescale\", every = 5 }"}}, "unknown table 'thermostat'");
    check_one({{steps, steps + "\nstart = \"euler\""}}, "'start'");
    check_one({{gravity, gravity + "\nsoftening = -0.1"}}, "'softening'");
    check_one({{"newtonian-gravity", "newton"}, {"gravitational_constant = 1.0\n", ""}}, "'type'");
}

TEST_CASE("tables of a fluid are explained to the writer of a few-body deck") {
    for (const std::string name : {"system", "potential", "neighbors", "argon"}) {
        const auto found = complaints(stars_deck + "\n[" + name + "]\n");
        REQUIRE(found.size() == 1);
        CHECK(line_shown(found[0]) == "[" + name + "]");
        CHECK_THAT(found[0].message, Contains("belongs to a fluid"));
    }
}
