#include "cli/command_words.hpp"
#include "io/files/input_file.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"
#include "report/report.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("report writes its page into the directory or where it is told, and prints where") {
    const DeckFolder folder;
    const Deck deck = folder.load();
    run_until(deck, total_steps(deck.stages()));
    const std::string directory = deck.directory.string();
    CHECK(said([&] { command({"report", directory}); }).out == directory + "/report.html\n");
    CHECK_THAT(read_input(deck.directory / "report.html"), Catch::StartsWith("<!DOCTYPE html>"));
    const std::string other = (folder / "other.html").string();
    CHECK(said([&] { command({"report", directory, directory, "--out", other}); }).out == other + "\n");
    CHECK(input_is_there(other));
    CHECK_THROWS_AS(command({"report", directory, "--out", (folder / "no/where.html").string()}), FileError);
}

TEST_CASE("report prints the data of its page as one line of JSON, and writes nothing") {
    const DeckFolder folder;
    const Deck deck = folder.load();
    run_until(deck, total_steps(deck.stages()));
    const std::string directory = deck.directory.string();
    CHECK(said([&] {
              command({"report", directory, "--json"});
          }).out == to_json_line(page_data(report_on(deck.directory))) + "\n");
    CHECK_FALSE(input_is_there(deck.directory / "report.html"));
}
