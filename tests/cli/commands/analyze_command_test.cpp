#include "analyze/thermo_report.hpp"
#include "cli/command_words.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("analyze prints the report of a run, in words or as JSON") {
    const DeckFolder folder;
    const Deck deck = folder.load({"output.thermo.every=2"});
    run_until(deck, total_steps(deck.stages()));
    const RecordedRun run = recorded_run(deck.directory);
    const std::string path = deck.directory.string();
    CHECK(said([&] { command({"analyze", path}); }).out == thermo_document(thermo_report(run)).text);
    CHECK(said([&] {
              command({"analyze", path, "--json"});
          }).out == to_json(thermo_document(thermo_report(run)).data) + "\n");
    CHECK(said([&] {
              command({"analyze", path, "thermo", "--from", "0.12"});
          }).out == thermo_document(thermo_report(run, 0.12)).text);
    CHECK_THROWS_AS(command({"analyze", path + "-nowhere"}), DataError);
}

TEST_CASE("analyze writes the tables of what it measures beside the run's own") {
    const DeckFolder folder;
    const Deck deck = folder.load({"output.trajectory.every=2"});
    run_until(deck, total_steps(deck.stages()));
    const std::string path = deck.directory.string();
    const Said once = said([&] { command({"analyze", path, "rdf", "rdf"}); });
    CHECK_THAT(once.out, Contains("31 frames of 108 atoms") && Contains("20 measured, 0.008 tau apart"));
    CHECK(std::filesystem::exists(deck.directory / "analysis/rdf.csv"));
    CHECK_FALSE(std::filesystem::exists(deck.directory / "rdf.csv"));
    CHECK_THROWS_AS(command({"analyze", path, "rdf"}), InputError);
    CHECK_NOTHROW(said([&] { command({"analyze", path, "rdf", "--force"}); }));
    CHECK_THROWS_AS(command({"analyze", path, "rdf", "--out", path, "--force"}), InputError);
}
