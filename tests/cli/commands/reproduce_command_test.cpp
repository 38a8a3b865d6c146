#include "cli/command_words.hpp"
#include "deck/deck_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

// Rows are run by the tests in tests/cli: they are processes of the program.

TEST_CASE("reproduce refuses tables and rows that there are not, and touches nothing") {
    const TemporaryFolder folder;
    const std::string out = (folder / "out").string();
    CHECK_THROWS_WITH(command({"reproduce", "rahman1964", "--out", out}),
                      "unknown table 'rahman1964' to reproduce, allowed: verlet1967");
    for (const char* row : {"0.86", "0.85:0.787", "0.85:", ":0.786", "x", "", "0.85:0.786:1", "nan"}) {
        INFO(row);
        CHECK_THROWS_WITH(command({"reproduce", "verlet1967", "--out", out, "--rows", "0.45", "--rows", row}),
                          Contains("--rows: the table has no row '" + std::string(row) + "'"));
    }
    CHECK_FALSE(std::filesystem::exists(out));
}

TEST_CASE("a table to reproduce is named, and jobs are at least one") {
    const auto parsed = [](const std::vector<std::string>& words) { CommandLine().parse(words); };
    CHECK_NOTHROW(parsed({"reproduce", "verlet1967", "--rows", "0.85,0.75:1.07", "--quick"}));
    CHECK_THROWS_AS(parsed({"reproduce"}), CLI::ParseError);
    CHECK_THROWS_AS(parsed({"reproduce", "verlet1967", "--jobs", "0"}), CLI::ParseError);
}
