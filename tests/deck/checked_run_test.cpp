#include "deck/checked_run.hpp"

#include <fmt/format.h>

#include "deck/deck_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("a checked run has the start of a fluid and the threads that were asked for, few bodies have no start") {
    Diagnostics diagnostics;
    const CheckedRun fluid = checked_run(DeckFolder().load(), 2, "portable", diagnostics);
    CHECK(fluid.atoms() == 108);
    CHECK(fluid.execution.threads() == 2);
    CHECK(fluid.execution.simd() == SimdLevel::portable);
    const CheckedRun bodies = checked_run(DeckFolder(radial_deck).load(), 2, "", diagnostics);
    CHECK(!bodies.atoms());
    CHECK(bodies.execution.threads() == 1);
}

TEST_CASE("the box of a start file is checked against the deck, and the instruction set against the processor") {
    const DeckFolder folder;
    const std::string start = (folder / "start.xyz").string();
    std::ofstream(start) << "1\nLattice=\"3 0 0 0 3 0 0 0 3\" Properties=species:S:1:pos:R:3\nX 1 1 1\n";
    const std::string with_file = changed(
        small_deck, {{"lattice = { type = \"fcc\", cells = 3 }\ndensity = 0.8", fmt::format("file = \"{}\"", start)}});
    Diagnostics diagnostics;
    CHECK_THROWS_WITH(checked_run(DeckFolder(with_file).load(), 1, "", diagnostics), Contains("cutoff"));
    CHECK_THROWS_AS(checked_run(folder.load(), 1, "abacus", diagnostics), InputError);
}

TEST_CASE("a check reports on decks of both kinds") {
    Diagnostics diagnostics;
    const Deck fluid = DeckFolder().load();
    const Document of_fluid = check_report(fluid, checked_run(fluid, 1, "", diagnostics));
    CHECK_THAT(of_fluid.text, Contains("atoms     108\n"));
    CHECK(of_fluid.data["seconds"].number() > 0.0);
    const Deck bodies = DeckFolder(radial_deck).load();
    CHECK_THAT(check_report(bodies, checked_run(bodies, 1, "", diagnostics)).text, Contains("bodies    1"));
}
