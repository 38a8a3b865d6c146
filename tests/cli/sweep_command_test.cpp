#include "deck/deck_fixtures.hpp"
#include "ljmd/cli/commands.hpp"
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
    CHECK_THROWS_WITH(sweep_command({.deck = deck, .out = out}),
                      Contains("from --grid or from --list, one of the two"));
    CHECK_THROWS_WITH(sweep_command({.deck = deck, .grids = {one}, .list = "points.csv", .out = out}),
                      Contains("from --grid or from --list, one of the two"));
    CHECK_THROWS_WITH(sweep_command({.deck = deck + "x", .grids = {one}, .out = out}), Contains("no such file"));
    CHECK_THROWS_WITH(sweep_command({.deck = deck, .grids = {"system.temperature=1:2:1"}, .out = out}),
                      Contains("COUNT is '1'"));
    CHECK_THROWS_WITH(sweep_command({.deck = deck, .grids = {"system.temperature=-1|2"}, .out = out}),
                      Contains("(temperature=-1)") && Contains("1 error. Nothing was run."));
    CHECK_THROWS_AS(sweep_command({.deck = deck, .list = (folder / "none.csv").string(), .out = out}), DataError);
    CHECK_FALSE(std::filesystem::exists(out));
}
