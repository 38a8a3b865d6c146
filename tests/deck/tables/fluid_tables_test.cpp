#include "deck/tables/fluid_tables.hpp"

#include "deck/deck_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;

TEST_CASE("tables that a fluid's deck leaves out have their defaults") {
    const Deck deck = DeckFolder(small_deck).load();
    const Placed<FluidTables>& tables = deck.fluid();
    CHECK(tables.units == "reduced");
    CHECK_FALSE(tables.argon.has_value());
    CHECK(tables.neighbors.method == NeighborSpec().method);
    CHECK(tables.neighbors.skin == NeighborSpec().skin);
    CHECK_FALSE(tables.neighbors.every.has_value());
    CHECK(tables.performance.precision == "double");
    CHECK(tables.analysis.asked.empty());
    CHECK_FALSE(tables.has(&FluidTables::neighbors));
    CHECK(tables.sound(&FluidTables::neighbors));
}

TEST_CASE("analyses are chosen in the order of their names, with the options of their tables") {
    const Deck deck = DeckFolder(small_deck + "\n[analysis]\nvacf = {}\nrdf = { bins = 17, radius = 1.5 }\n").load();
    const auto& asked = deck.fluid().analysis.asked;
    REQUIRE(asked.size() == 2);
    CHECK(asked[0].name == "rdf");
    CHECK(settings_in_words(asked[0].settings) == "bins=17 radius=1.5 every=200");
    CHECK(asked[1].name == "vacf");
}

TEST_CASE("what is written is told from a default, wherever it is written") {
    const auto written = [](const std::string& text, const std::vector<std::string>& settings) {
        return DeckFolder(text).load(settings).neighbors().written(&NeighborSpec::skin);
    };
    CHECK_FALSE(written(small_deck, {}));
    CHECK_FALSE(written(small_deck + "\n[neighbors]\n", {}));
    CHECK_FALSE(written(small_deck, {"neighbors.method=cells"}));
    CHECK_FALSE(written(small_deck, {"neighbors={ method = \"cells\" }"}));
    CHECK(written(small_deck + "\n[neighbors]\nskin = 0.3\n", {}));
    CHECK(written("neighbors.skin = 0.3\n" + small_deck, {}));
    CHECK(written("neighbors = { skin = 0.3 }\n" + small_deck, {}));
    CHECK(written(small_deck, {"neighbors.skin=0.3"}));
    CHECK(written(small_deck, {"neighbors={ skin = 0.3 }"}));
}
