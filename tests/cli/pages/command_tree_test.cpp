#include "cli/pages/command_tree.hpp"

#include "catch.hpp"

#include "cli/pages/made_tree.hpp"

using namespace ljmd;
using namespace ljmd::test;

TEST_CASE("arguments and options of a command are told apart") {
    const DescribedCommand run = made_tree().commands.front();
    REQUIRE(run.arguments().size() == 1);
    CHECK(run.arguments().front().value == "DECK");
    CHECK(run.named_options().size() == 4);
    CHECK(made_tree().names() == std::vector<std::string>{"run", "analyze", "version"});
}
