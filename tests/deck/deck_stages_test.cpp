#include "deck/deck_stages.hpp"

#include "deck/deck_fixtures.hpp"
#include "deck/deck_schema.hpp"
#include "input/deck_file.hpp"
#include "integrators/integrator.hpp"

using namespace ljmd;
using namespace ljmd::test;

namespace {

/// The stages of a deck of a fluid that was validated, whatever was found.
std::vector<Stage> stages_in(const std::string& text) {
    Diagnostics ignored;
    const DeckFile file = parse_deck("deck.toml", text, ignored);
    return stages_of(Placed<FluidTables>(
        validate(file.table, {file.source, 0, 0, 1}, deck_schema(DeckKind::fluid), std::nullopt, ignored)));
}

const std::string rescale = "thermostat = { type = \"rescale\", every = 5 }";

}  // namespace

TEST_CASE("stages are those of the deck, with the temperature of the system where they have none of their own") {
    const std::vector<Stage> stages = stages_in(
        changed(small_deck, {{"sample = true", "sample = true\ntemperature = 0.7\nintegrator = \"leapfrog\""}}));
    REQUIRE(stages.size() == 2);
    CHECK(stages[0].name == "equilibrate");
    CHECK(stages[0].temperature == 1.0);
    CHECK(stages[0].thermostat->name == "rescale");
    CHECK(settings_in_words(stages[0].thermostat->settings) == "every=5");
    CHECK(stages[0].seed == 7);
    CHECK(stages[1].temperature == 0.7);
    CHECK(stages[1].integrator.name == "leapfrog");
    CHECK(stages[1].sample);
    CHECK_FALSE(stages[1].thermostat);
}

TEST_CASE("a thermostat of a wrong type is left out, and one without a valid temperature has a stand-in") {
    CHECK_FALSE(stages_in(changed(small_deck, {{"rescale", "rescaling"}}))[0].thermostat);
    CHECK_FALSE(stages_in(changed(small_deck, {{rescale, "thermostat = 5"}}))[0].thermostat);
    for (const char* wrong : {"temperature = -1.0\n", "temperature = \"hot\"\n", ""}) {
        const std::vector<Stage> stages = stages_in(changed(small_deck, {{"temperature = 1.0\n", wrong}}));
        CHECK(stages[0].temperature > 0.0);
        CHECK(stages[0].thermostat);
    }
}

TEST_CASE("a few-body stage is sampled unless its table says otherwise, and may take integrators of its own") {
    const Deck deck =
        DeckFolder(stars_deck)
            .load({"stage.orbits.integrator=position-verlet", "stage.orbits.start=euler", "stage.orbits.reverse=true"});
    const std::vector<Stage> stages = stages_of(deck.few_body());
    REQUIRE(stages.size() == 1);
    CHECK(stages[0].sample);
    CHECK(stages[0].reverse);
    CHECK(stages[0].integrator.name == "position-verlet");
    CHECK(settings_in_words(stages[0].integrator.settings) == "start=euler");
    CHECK(stages[0].steps == 95);
    CHECK(stages[0].time_step == 0.01);
    CHECK_FALSE(stages[0].thermostat);
}

TEST_CASE("a stage of a fluid has the baths of its table, with their options and places") {
    const std::vector<std::string> settings{
        "stage.equilibrate.thermostat={ type = \"langevin\", time = 0.25 }", "stage.equilibrate.temperature=1.5",
        "stage.equilibrate.barostat={ type = \"stochastic-cell-rescaling\", pressure = 2.0 }"};
    const Deck deck = DeckFolder().load(settings);
    const auto& stages = deck.fluid().stages;
    REQUIRE(stages.size() == 2);
    REQUIRE(stages[0].thermostat.has_value());
    CHECK(stages[0].thermostat->name == "langevin");
    CHECK(settings_in_words(stages[0].thermostat->settings) == "time=0.25");
    CHECK(stages[0].location_of_type(&Stage::thermostat).source->name == "--set " + settings[0]);
    REQUIRE(stages[0].barostat.has_value());
    CHECK(stages[0].barostat->name == "stochastic-cell-rescaling");
    CHECK(stages[0].temperature == 1.5);
    CHECK_FALSE(stages[1].thermostat.has_value());
    CHECK_FALSE(stages[1].temperature.has_value());
    CHECK(stages[1].sample);
    CHECK(stages[1].location(&Stage::name).line == 21);
}

TEST_CASE("few bodies may take integrators that a fluid may not") {
    const auto choices = [](const Schema& schema) { return schema.find("integrator")->choices.size(); };
    const auto integrators = all_integrators();
    CHECK(choices(Placed<FewBodyStage>::schema("[[stage]]")) == integrators.size());
    CHECK(choices(Placed<Stage>::schema("[[stage]]")) ==
          static_cast<std::size_t>(std::ranges::count_if(
              integrators, [](const IntegratorMethod& method) { return !method.unbounded_only; })));
}
