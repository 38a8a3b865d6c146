#include "ljmd/analyze/thermo_report.hpp"
#include "ljmd/cli/commands.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/io/tables/json_text.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("analyze prints the report of a run, in words or as JSON") {
    const DeckFolder folder;
    const Deck deck = folder.load({"output.thermo.every=2"});
    run_until(deck, total_steps(deck.stages));
    const RecordedRun run = recorded_run(deck.directory);
    const std::string path = deck.directory.string();
    CHECK(said([&] { analyze_command({.path = path}); }).out == thermo_document(thermo_report(run)).text);
    CHECK(said([&] { analyze_command({.path = path, .json = true}); }).out ==
          to_json(thermo_document(thermo_report(run)).data) + "\n");
    CHECK(said([&] { analyze_command({.path = path, .names = {"thermo"}, .from = 0.12}); }).out ==
          thermo_document(thermo_report(run, 0.12)).text);
    CHECK_THROWS_AS(analyze_command({.path = path + "-nowhere"}), DataError);
}

TEST_CASE("analyze writes the tables of what it measures beside the run's own") {
    const DeckFolder folder;
    const Deck deck = folder.load({"output.trajectory.every=2"});
    run_until(deck, total_steps(deck.stages));
    const std::string path = deck.directory.string();
    const Said once = said([&] { analyze_command({.path = path, .names = {"rdf", "rdf"}}); });
    CHECK_THAT(once.out, Contains("31 frames of 108 atoms") && Contains("20 measured, 0.008 tau apart"));
    CHECK(std::filesystem::exists(deck.directory / "analysis/rdf.csv"));
    CHECK_FALSE(std::filesystem::exists(deck.directory / "rdf.csv"));
    CHECK_THROWS_AS(analyze_command({.path = path, .names = {"rdf"}}), InputError);
    CHECK_NOTHROW(said([&] { analyze_command({.path = path, .names = {"rdf"}, .force = true}); }));
    CHECK_THROWS_AS(analyze_command({.path = path, .names = {"rdf"}, .out = path, .force = true}), InputError);
}
