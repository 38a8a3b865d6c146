#include "app/run_fixtures.hpp"
#include "ljmd/app/commands.hpp"
#include "ljmd/app/thermo_report.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;

TEST_CASE("analyze prints the report of a run, in words or as JSON") {
    const DeckFolder folder;
    const Deck deck = folder.load({"output.thermo.every=2"});
    run_until(deck, deck.total_steps());
    const ThermoReport report = thermo_report(recorded_run(deck.directory));
    const std::string directory = deck.directory.string();
    CHECK(said([&] { analyze_command(directory, false); }).out == thermo_table(report));
    CHECK(said([&] { analyze_command(directory, true); }).out == thermo_json(report));
    CHECK_THROWS_AS(analyze_command(directory + "-nowhere", false), DataError);
}
