#include <filesystem>

#include "cli/command_words.hpp"
#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;

// The runs are made by the tests in tests/cli/references.py: they are processes of the program.

TEST_CASE("a reference that is refused touches nothing") {
    const test::TemporaryFolder folder;
    const std::string out = (folder / "out").string();
    const auto reference = [&](const std::string& density, const std::vector<std::string>& more = {}) {
        std::vector<std::string> words{"reference", "--temperature", "1.0", "--density",
                                       density,     "--out",         out,   "--quiet"};
        words.insert(words.end(), more.begin(), more.end());
        test::command(words);
    };
    CHECK_THROWS_WITH(reference("0.3"), Contains("separates into vapour and liquid"));
    CHECK_THROWS_WITH(reference("0.8", {"--properties", "entropy"}), Contains("unknown property 'entropy'"));
    for (const char* wrong : {"energy", "energy=", "=0.1", "energy=small"}) {
        INFO(wrong);
        CHECK_THROWS_AS(reference("0.8", {std::string("--error=") + wrong}), InputError);
    }
    CHECK_FALSE(std::filesystem::exists(out));
}

TEST_CASE("a reference wants a temperature, and a density or a pressure but not both") {
    const auto parsed = [](const std::vector<std::string>& words) { CommandLine().parse(words); };
    CHECK_NOTHROW(parsed({"reference", "--temperature", "1.2", "--density", "0.75", "--error", "energy=0.01,p=0.1"}));
    CHECK_NOTHROW(parsed({"reference", "--temperature", "1.2", "--pressure", "1", "--properties", "all"}));
    CHECK_THROWS_AS(parsed({"reference", "--density", "0.75"}), CLI::ParseError);
    CHECK_THROWS_AS(parsed({"reference", "--temperature", "1", "--density", "0.8", "--pressure", "1"}),
                    CLI::ParseError);
    CHECK_THROWS_AS(parsed({"reference", "--temperature", "120 K", "--density", "0.8"}), CLI::ParseError);
    CHECK_THROWS_AS(parsed({"reference", "--temperature", "1", "--density", "0.8", "--replicas", "1"}),
                    CLI::ParseError);
}
