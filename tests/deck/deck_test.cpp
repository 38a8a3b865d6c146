#include "deck/deck.hpp"

#include "deck/deck_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("what a deck leaves out has its default") {
    const DeckFolder folder(changed(small_deck, {{"title = \"A small liquid\"", ""}, {"seed = 7\n", ""}}));
    Diagnostics diagnostics;
    const auto deck = load_deck(folder.deck_path(), {}, false, diagnostics);
    REQUIRE(deck.has_value());
    CHECK(diagnostics.entries().empty());
    CHECK(deck->path == folder.deck_path().string());
    CHECK(deck->source == content_of(folder.deck_path()));
    CHECK(deck->title.empty());
    CHECK_FALSE(deck->units().has_value());
    CHECK(deck->directory == "runs/deck");
    CHECK(deck->sample_every() == 10);
    CHECK_FALSE(deck->trajectory.has_value());
    CHECK(deck->settings.empty());
    CHECK(deck->system().seed == 1);
    CHECK(deck->neighbors().method == "verlet-list");
    CHECK(deck->neighbors().skin == 0.3);
    REQUIRE(deck->stages().size() == 2);
    CHECK(deck->stages()[0].integrator.name == "velocity-verlet");
    CHECK_FALSE(deck->stages()[0].sample);
    CHECK(deck->stages()[0].temperature == 1.0);  // that of [system]
}

TEST_CASE("what a deck says arrives in the run") {
    const DeckFolder folder(changed(small_deck, {{"thermostat =", "temperature = 1.5\nthermostat ="}}) + argon_table +
                            "[neighbors]\nmethod = \"cells\"\n"
                            "[output]\ndirectory = \"somewhere/else\"\nthermo = { every = 3 }\n"
                            "trajectory = { format = \"xyz\", every = 7, velocities = true, units = \"si\" }\n");
    Diagnostics diagnostics;
    const auto deck = load_deck(folder.deck_path(), {}, false, diagnostics);
    REQUIRE(deck.has_value());
    CHECK(deck->title == "A small liquid");
    REQUIRE(deck->stages().size() == 2);
    CHECK(deck->stages()[0].name == "equilibrate");
    CHECK(deck->stages()[0].time_step == 0.004);
    CHECK(deck->stages()[0].steps == 20);
    CHECK(deck->stages()[0].temperature == 1.5);
    CHECK(deck->stages()[0].thermostat->name == "rescale");
    CHECK(settings_in_words(deck->stages()[0].thermostat->settings) == "every=5");
    CHECK(deck->stages()[1].temperature == 1.0);
    CHECK(deck->stages()[1].sample);
    CHECK(total_steps(deck->stages()) == 60);
    CHECK(deck->neighbors().method == "cells");
    CHECK(deck->directory == "somewhere/else");
    CHECK(deck->sample_every() == 3);
    REQUIRE(deck->trajectory.has_value());
    CHECK(deck->trajectory->format == "xyz");
    CHECK(deck->trajectory->every == 7);
    CHECK(deck->trajectory->velocities);
    CHECK(deck->trajectory->si());
    REQUIRE(deck->units().has_value());
    CHECK(deck->units()->kelvin() == Approx(119.8).epsilon(1e-14));
}

TEST_CASE("settings win over the text, later ones over earlier ones") {
    const DeckFolder folder;
    const std::vector<std::string> settings{"system.density=0.5", "system.density=0.6", "stage.production.steps=100",
                                            "output.thermo.every=2", "title=Another"};
    const Deck deck = folder.load(settings);
    CHECK(deck.system().density == 0.6);
    CHECK(deck.stages()[0].steps == 20);
    CHECK(deck.stages()[1].steps == 100);
    CHECK(deck.sample_every() == 2);  // a table that the text has not
    CHECK(deck.title == "Another");
    CHECK(deck.settings == settings);
    CHECK(deck.source == content_of(folder.deck_path()));
}

TEST_CASE("a mistake in a setting points at the setting") {
    const auto found = complaints(small_deck, {"system.densty=0.5", "system.temperature=60", "stage.melt.steps=1"});
    REQUIRE(found.size() == 3);
    for (const char* setting : {"--set system.densty=0.5", "--set system.temperature=60", "--set stage.melt.steps=1"}) {
        CHECK(std::count_if(found.begin(), found.end(),
                            [&](const Diagnostic& d) { return line_shown(d) == setting; }) == 1);
    }
}

TEST_CASE("mistakes of the text, of single values and of sense are found at once") {
    const auto found = complaints(
        changed(small_deck,
                {{"seed = 7", "sed = 7"}, {"time_step = 0.004", "time_step = -1"}, {"cutoff = 2.0", "cutoff = 2.9"}}));
    REQUIRE(found.size() == 3);
    CHECK_THAT(found[0].message, Contains("unknown key 'sed'"));
    CHECK(line_shown(found[1]) == "time_step = -1");
    CHECK_THAT(found[2].message, Contains("more than half the box"));
}

TEST_CASE("a deck without its main tables is told what is missing") {
    std::string all;
    for (const Diagnostic& entry : complaints("title = \"nothing else\"\n")) {
        all += entry.message + "\n";
    }
    CHECK_THAT(all, Contains("'system'") && Contains("'potential'") && Contains("'stage'"));
    CHECK_THAT(all, !Contains("'neighbors'") && !Contains("'output'") && !Contains("'analysis'"));
}

TEST_CASE("with a substance, quantities may have units") {
    const DeckFolder folder(changed(small_deck, {{"density = 0.8", "density = \"1.374 g/cm3\""},
                                                 {"temperature = 1.0", "temperature = \"119.8 K\""},
                                                 {"cutoff = 2.0", "cutoff = \"6.81 angstrom\""},
                                                 {"time_step = 0.004", "time_step = \"10 fs\""}}) +
                            argon_table);
    const Deck deck = folder.load();
    CHECK(deck.system().temperature.value() == Approx(1.0).epsilon(1e-12));
    CHECK(deck.potential().radius == Approx(2.0).epsilon(1e-12));
    CHECK(deck.system().density.value() == Approx(0.81772).epsilon(1e-4));
    CHECK(deck.stages()[0].time_step == Approx(0.010 / 2.1564).epsilon(1e-4));  // tau of argon: 2.1564 ps
}

TEST_CASE("a mistake in the substance is one mistake, whatever else is in its units") {
    const std::string deck = changed(small_deck, {{"temperature = 1.0", "temperature = \"119.8 K\""}});
    const auto wrong_unit = complaints(deck + changed(argon_table, {{"39.948 u", "39.948 bar"}}));
    REQUIRE(wrong_unit.size() == 1);
    CHECK(line_shown(wrong_unit[0]) == "mass = \"39.948 bar\"");

    const auto missing = complaints(deck + changed(argon_table, {{"mass = \"39.948 u\"\n", ""}}));
    REQUIRE(missing.size() == 1);
    CHECK_THAT(missing[0].message, Contains("'mass'"));

    const auto beyond_numbers = complaints(deck + changed(argon_table, {{"3.405 angstrom", "1e-300 m"}}));
    REQUIRE(beyond_numbers.size() == 1);
    CHECK(line_shown(beyond_numbers[0]) == "[argon]");
    CHECK_THAT(beyond_numbers[0].message, Contains("beyond the range"));
}
