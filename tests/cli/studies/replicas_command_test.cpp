#include "ljmd/cli/studies/replicas_command.hpp"

#include "deck/deck_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

// Replicas are run by the tests in tests/cli/until.py: they are processes of the program.

TEST_CASE("replicas that are wrong touch nothing") {
    const DeckFolder folder;
    const std::string out = (folder / "out").string();
    CHECK_THROWS_WITH(replicas_command({.deck = folder.deck_path().string() + "x", .settings = {}}, out, 2, 1),
                      Contains("no such file"));
    CHECK_THROWS_WITH(
        replicas_command({.deck = folder.deck_path().string(), .settings = {"system.densty=1"}}, out, 2, 1),
        Contains("unknown key 'densty'"));
    const DeckFolder bodies(stars_deck);
    CHECK_THROWS_WITH(replicas_command({.deck = bodies.deck_path().string(), .settings = {}}, out, 2, 1),
                      Contains("a motion of few bodies has none"));
    CHECK_FALSE(std::filesystem::exists(out));
    CHECK_FALSE(holds_replicas(out));
}
