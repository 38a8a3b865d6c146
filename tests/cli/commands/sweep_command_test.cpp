#include "cli/command_words.hpp"
#include "deck/deck_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

// Points are run by the tests in tests/cli: they are processes of the program.

TEST_CASE("a sweep that is wrong touches nothing") {
    const DeckFolder folder;
    const std::string deck = folder.deck_path().string();
    const std::string out = (folder / "out").string();
    const std::string one = "system.temperature=1|2";
    CHECK_THROWS_WITH(command({"sweep", deck, "--out", out}), Contains("from --grid or from --list, one of the two"));
    CHECK_THROWS_WITH(command({"sweep", deck, "--grid", one, "--list", "points.csv", "--out", out}),
                      Contains("from --grid or from --list, one of the two"));
    CHECK_THROWS_WITH(command({"sweep", deck + "x", "--grid", one, "--out", out}), Contains("no such file"));
    CHECK_THROWS_WITH(command({"sweep", deck, "--grid", "system.temperature=1:2:1", "--out", out}),
                      Contains("COUNT is '1'"));
    CHECK_THROWS_WITH(command({"sweep", deck, "--grid", "system.temperature=-1|2", "--out", out}),
                      Contains("(temperature=-1)") && Contains("1 error. Nothing was run."));
    CHECK_THROWS_AS(command({"sweep", deck, "--list", (folder / "none.csv").string(), "--out", out}), DataError);
    CHECK_FALSE(std::filesystem::exists(out));
}

TEST_CASE("a sweep takes a deck and points, a worker a directory") {
    const auto parsed = [](const std::vector<std::string>& words) { CommandLine().parse(words); };
    CHECK_NOTHROW(parsed({"sweep", "deck.toml", "--grid", "system.temperature=1|2", "--jobs", "2"}));
    CHECK_NOTHROW(parsed({"sweep", "--work", "1/2", "runs/sweep"}));
    CHECK_THROWS_AS(parsed({"sweep"}), CLI::ParseError);
    CHECK_THROWS_AS(parsed({"sweep", "deck.toml", "--jobs", "0"}), CLI::ParseError);
    CHECK_THROWS_AS(parsed({"sweep", "--work", "1/2", "runs/sweep", "--grid", "system.temperature=1|2"}),
                    CLI::ParseError);
}
