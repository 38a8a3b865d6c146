#include "engine/tables/potential_table.hpp"

#include "deck/deck_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;

TEST_CASE("a deck's potential has its formula, numbers, truncation and radii") {
    const Deck deck =
        DeckFolder(
            changed(
                small_deck,
                {{"type = \"lennard-jones\"", "type = \"morse\"\nwell_depth = 2.0\nsteepness = 6.0\nminimum = 1.25"},
                 {"truncation = \"force-shifted\"", "truncation = \"switched\"\nswitch_start = 1.5\ntail = false"}}))
            .load();
    const PairPotential potential = pair_potential_of(deck.potential());
    CHECK(potential.formula() == "morse");
    CHECK(potential.truncation() == "switched");
    CHECK(potential.cutoff().radius == 2.0);
    CHECK(potential.cutoff().switch_start == 1.5);
    CHECK(potential.parameters() ==
          PairPotential::Parameters{{"well_depth", 2.0}, {"steepness", 6.0}, {"minimum", 1.25}});
}

TEST_CASE("the keys of a formula and a truncation are known where these are chosen") {
    using Table = Placed<PotentialTable>;
    CHECK(Table::key(&PotentialTable::radius) == "cutoff");
    CHECK(Table::key(&PotentialTable::switch_start) == "switch_start");
    const auto parsed = DeckFolder().load().potential();
    CHECK(parsed.has(&PotentialTable::radius));
    CHECK_FALSE(parsed.has(&PotentialTable::switch_start));
    CHECK_FALSE(parsed.has_tail());
    CHECK(pair_potential_of(parsed).parameters().empty());
}
