#include "ljmd/cli/pages/command_tree.hpp"

#include <catch2/catch.hpp>

#include "cli/pages/made_tree.hpp"

using namespace ljmd;
using namespace ljmd::test;

TEST_CASE("arguments and options of a command are told apart") {
    const Command run = made_tree().commands.front();
    REQUIRE(run.arguments().size() == 1);
    CHECK(run.arguments().front().value == "DECK");
    CHECK(run.named_options().size() == 4);
    CHECK(made_tree().names() == std::vector<std::string>{"run", "analyze", "version"});
}

TEST_CASE("the word for a value says what it can be") {
    const CommandTree tree = made_tree();
    CHECK(possible_values("COMMAND", tree).words == tree.names());
    CHECK(possible_values("P", tree).words == std::vector<std::string>{"double", "mixed"});
    CHECK(possible_values("LEVEL", tree).words.front() == "portable");
    CHECK(possible_values("ANALYSIS", tree).words.back() == "thermo");
    CHECK(possible_values("KEY=VALUE", tree).keys);
    CHECK(possible_values("DECK", tree).decks);
    CHECK(possible_values("RUNDIR|TRAJECTORY", tree).files);
    CHECK(possible_values("DIR", tree).directories);
    const PossibleValues unknown = possible_values("TIME", tree);
    CHECK((unknown.words.empty() && !unknown.keys && !unknown.decks && !unknown.files && !unknown.directories));
}
