#include "ljmd/cli/studies/reproduce_options.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace ljmd;

TEST_CASE("a table to reproduce is named, and jobs are at least one") {
    const auto parsed = [](std::vector<std::string> arguments) {
        CLI::App app("test", "ljmd");
        const ReproduceCommand command(app);
        std::reverse(arguments.begin(), arguments.end());
        app.parse(arguments);
        return command.parsed();
    };
    CHECK(parsed({"reproduce", "verlet1967", "--rows", "0.85,0.75:1.07", "--quick"}));
    CHECK_THROWS_AS(parsed({"reproduce"}), CLI::ParseError);
    CHECK_THROWS_AS(parsed({"reproduce", "verlet1967", "--jobs", "0"}), CLI::ParseError);
}
