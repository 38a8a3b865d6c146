#include "ljmd/cli/studies/sweep_options.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace ljmd;

TEST_CASE("a sweep takes a deck and points, a worker a directory") {
    const auto parsed = [](std::vector<std::string> arguments) {
        CLI::App app("test", "ljmd");
        const SweepCommand command(app);
        std::reverse(arguments.begin(), arguments.end());
        app.parse(arguments);
        return command.parsed();
    };
    CHECK(parsed({"sweep", "deck.toml", "--grid", "system.temperature=1|2", "--jobs", "2"}));
    CHECK(parsed({"sweep", "--work", "1/2", "runs/sweep"}));
    CHECK_THROWS_AS(parsed({"sweep"}), CLI::ParseError);
    CHECK_THROWS_AS(parsed({"sweep", "deck.toml", "--jobs", "0"}), CLI::ParseError);
    CHECK_THROWS_AS(parsed({"sweep", "--work", "1/2", "runs/sweep", "--grid", "system.temperature=1|2"}),
                    CLI::ParseError);
}
