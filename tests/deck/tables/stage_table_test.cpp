#include "ljmd/deck/tables/stage_table.hpp"

#include "deck/deck_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;

TEST_CASE("a stage of a fluid has the baths of its table, with their options and places") {
    const std::vector<std::string> settings{
        "stage.equilibrate.thermostat={ type = \"langevin\", time = 0.25 }", "stage.equilibrate.temperature=1.5",
        "stage.equilibrate.barostat={ type = \"stochastic-cell-rescaling\", pressure = 2.0 }"};
    const Deck deck = DeckFolder().load(settings);
    const auto& stages = deck.fluid().stages;
    REQUIRE(stages.size() == 2);
    REQUIRE(stages[0].thermostat.has_value());
    CHECK(stages[0].thermostat->method.plugin.name == "langevin");
    CHECK(settings_in_words(stages[0].thermostat->method.values) == "time=0.25");
    CHECK(stages[0].thermostat->location(&ThermostatTable::method).source->name == "--set " + settings[0]);
    REQUIRE(stages[0].barostat.has_value());
    CHECK(stages[0].barostat->method.plugin.name == "stochastic-cell-rescaling");
    CHECK(stages[0].temperature == 1.5);
    CHECK_FALSE(stages[1].thermostat.has_value());
    CHECK_FALSE(stages[1].temperature.has_value());
    CHECK(stages[1].sample);
    CHECK(stages[1].location(&StageTable::name).line == 21);
}

TEST_CASE("stages have the defaults of the engine, but those of few bodies are sampled by default") {
    const FluidStageTable fluid;
    CHECK(fluid.integrator.plugin.name == Stage().integrator.plugin.name);
    CHECK(fluid.sample == Stage().sample);
    CHECK(fluid.reverse == Stage().reverse);
    CHECK(FewBodyStageTable().sample);
}

TEST_CASE("few bodies may take integrators that a fluid may not") {
    const auto choices = [](const Schema& schema) { return schema.find("integrator")->choices.size(); };
    const auto integrators = all_integrators();
    CHECK(choices(Placed<FewBodyStageTable>::schema("[[stage]]")) == integrators.size());
    CHECK(choices(Placed<FluidStageTable>::schema("[[stage]]")) ==
          static_cast<std::size_t>(std::ranges::count_if(
              integrators, [](const IntegratorMethod& method) { return !method.unbounded_only; })));
}
