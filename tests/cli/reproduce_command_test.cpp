#include "deck/deck_fixtures.hpp"
#include "ljmd/cli/commands.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

// Rows are run by the tests in tests/cli: they are processes of the program.

TEST_CASE("reproduce refuses tables and rows that there are not, and touches nothing") {
    const TemporaryFolder folder;
    const std::string out = (folder / "out").string();
    CHECK_THROWS_WITH(reproduce_command({.what = "rahman1964", .out = out}),
                      "unknown table 'rahman1964' to reproduce, allowed: verlet1967");
    for (const char* row : {"0.86", "0.85:0.787", "0.85:", ":0.786", "x", "", "0.85:0.786:1", "nan"}) {
        INFO(row);
        CHECK_THROWS_WITH(reproduce_command({.what = "verlet1967", .out = out, .rows = {"0.45", row}}),
                          Contains("--rows: the table has no row '" + std::string(row) + "'"));
    }
    CHECK_FALSE(std::filesystem::exists(out));
}
