#include "deck/mistake_report.hpp"

#include "deck/deck_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;

namespace {

const std::string rescale_line = "thermostat = { type = \"rescale\", every = 5 }";

Diagnostic only(const std::vector<Mistake>& mistakes, const Deck& deck) {
    Diagnostics diagnostics;
    report(mistakes, deck.fluid(), diagnostics);
    REQUIRE(diagnostics.entries().size() == 1);
    return diagnostics.entries().front();
}

}  // namespace

TEST_CASE("a mistake is shown at the key to change, in the table, stage or analysis that has it") {
    const DeckFolder folder(small_deck + "\n[analysis.rdf]\nradius = 2.5\n");
    const Deck deck = folder.load();
    const Diagnostic of_table = only({{"potential", "", 0, "is 2", true, {"cutoff", "truncation"}, "take 1"}}, deck);
    CHECK(of_table.message == "'cutoff' in [potential] is 2");
    CHECK(of_table.hint == "take 1");
    CHECK(of_table.severity == Severity::error);
    CHECK(line_shown(of_table) == "cutoff = 2.0");
    const Diagnostic of_stage = only({{"stage", "production", 1, "is long", true, {"steps"}, ""}}, deck);
    CHECK(of_stage.message == "'steps' in [[stage]] is long");
    CHECK(line_shown(of_stage) == "steps = 40");
    const Diagnostic of_analysis = only({{"analysis", "rdf", 0, "too far", false, {"radius"}, ""}}, deck);
    CHECK(of_analysis.message == "too far");
    CHECK(line_shown(of_analysis) == "radius = 2.5");
    const Diagnostic within = only({{"stage", "equilibrate", 0, "is bad", true, {"thermostat.type"}, ""}}, deck);
    CHECK(within.message == "'type' in thermostat is bad");
    CHECK(line_shown(within) == rescale_line);
}

TEST_CASE("what rests on a value that is wrong in itself is not reported in addition") {
    // The type is wrong, so it is not known whether the barostat has the thermostat that it needs.
    const std::string barostat = "\nbarostat = { type = \"stochastic-cell-rescaling\", pressure = 0.5 }";
    const auto found =
        complaints(changed(small_deck, {{rescale_line, "thermostat = { type = \"langvin\" }" + barostat}}));
    REQUIRE(found.size() == 1);
    CHECK(found[0].message.find("langvin") != std::string::npos);
    // And so is the temperature, which the thermostat shares with the start.
    const std::string canonical = "thermostat = { type = \"langevin\" }";
    CHECK(complaints(changed(small_deck, {{rescale_line, canonical}, {"temperature = 1.0", "temperature = -1.0"}}))
              .size() == 1);
}

TEST_CASE("a mistake in a key that no deck has is a mistake of the program") {
    const Deck deck = DeckFolder().load();
    Diagnostics diagnostics;
    CHECK_THROWS_AS(report({{"potential", "", 0, "is 2", true, {"cut-off"}, ""}}, deck.fluid(), diagnostics),
                    ContractViolation);
}
