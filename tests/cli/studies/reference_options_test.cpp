#include "ljmd/cli/studies/reference_options.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace ljmd;

TEST_CASE("a reference wants a temperature, and a density or a pressure but not both") {
    const auto parsed = [](std::vector<std::string> arguments) {
        CLI::App app("test", "ljmd");
        const ReferenceCommand command(app);
        std::reverse(arguments.begin(), arguments.end());
        app.parse(arguments);
        return command.parsed();
    };
    CHECK(parsed({"reference", "--temperature", "1.2", "--density", "0.75", "--error", "energy=0.01,p=0.1"}));
    CHECK(parsed({"reference", "--temperature", "1.2", "--pressure", "1", "--properties", "all"}));
    CHECK_THROWS_AS(parsed({"reference", "--density", "0.75"}), CLI::ParseError);
    CHECK_THROWS_AS(parsed({"reference", "--temperature", "1", "--density", "0.8", "--pressure", "1"}),
                    CLI::ParseError);
    CHECK_THROWS_AS(parsed({"reference", "--temperature", "120 K", "--density", "0.8"}), CLI::ParseError);
    CHECK_THROWS_AS(parsed({"reference", "--temperature", "1", "--density", "0.8", "--replicas", "1"}),
                    CLI::ParseError);
}
