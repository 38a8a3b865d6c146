#include "engine/tables/system_table.hpp"

#include "deck/deck_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;

TEST_CASE("atoms and box are what the deck says") {
    const Placed<SystemTable> system = DeckFolder().load().system();
    REQUIRE(system.lattice.has_value());
    CHECK_FALSE(system.lattice->is_random());
    CHECK(system.lattice->crystal() == Lattice::fcc);
    CHECK(system.lattice->cells == 3);
    CHECK_FALSE(system.lattice->atoms.has_value());
    CHECK_FALSE(system.file.has_value());
    CHECK(system.density == 0.8);
    CHECK(system.temperature == 1.0);
    CHECK(system.seed == 7);
    CHECK_FALSE(system.draws_velocities());
    CHECK_FALSE(system.wants_velocities_of_file());
    CHECK(system.location(&SystemTable::density).line == 5);
    CHECK(system.lattice->location(&LatticeTable::cells).line == 4);
}

TEST_CASE("starts and velocities have names") {
    const Deck deck = DeckFolder(changed(small_deck, {{"\"fcc\", cells = 3", "\"random\", atoms = 200"}})).load();
    CHECK(deck.system().lattice->is_random());
    CHECK(deck.system().lattice->atoms == 200);
    const auto crystal = changed(small_deck, {{"\"fcc\"", "\"simple-cubic\""}, {"cells = 3", "cells = 4"}});
    CHECK(DeckFolder(crystal).load().system().lattice->crystal() == Lattice::simple_cubic);
    CHECK(DeckFolder().load({"system.velocities=maxwell"}).system().draws_velocities());
    const std::vector<std::string> of_file{"system={ file = \"x.xyz\", temperature = 1.0, velocities = \"file\" }"};
    CHECK(DeckFolder().load(of_file).system().wants_velocities_of_file());
    CHECK(DeckFolder().load(of_file).system().seed == static_cast<Index>(FluidSpec().seed));
}

TEST_CASE("the numbers of a substance are in SI units") {
    const Deck deck = DeckFolder(small_deck + argon_table).load();
    REQUIRE(deck.fluid().argon.has_value());
    CHECK(deck.fluid().argon->sigma == Approx(3.405e-10));
    CHECK(deck.fluid().argon->epsilon == Approx(119.8 * 1.380649e-23));
    CHECK(deck.fluid().argon->mass == Approx(39.948 * 1.66053906660e-27));
}
