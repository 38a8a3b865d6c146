#include "cli/command_line.hpp"

#include "deck/deck_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

struct Ended {
    int code;
    Said said;
};

Ended ended(const std::vector<std::string>& words) {
    Ended found{};
    found.said = said([&] { found.code = run_command_line(words); });
    return found;
}

}  // namespace

TEST_CASE("a wrong command line ends with 2 and says what is wrong") {
    const auto complaint = [](const std::vector<std::string>& words) {
        const Ended found = ended(words);
        CHECK(found.code == 2);
        CHECK(found.said.out.empty());
        return found.said.err;
    };
    CHECK_THAT(complaint({}), Contains("Usage: ljmd"));
    CHECK_THAT(complaint({"rnu"}), Catch::StartsWith("error: unknown command 'rnu'") && Contains("'run'"));
    CHECK_THAT(complaint({"check", "a.toml", "b.toml"}), Contains("not expected: b.toml"));
    CHECK_THAT(complaint({"run"}), Contains("all options: ljmd run --help"));
    CHECK_THAT(complaint({"check", "no.toml"}), Contains("no such file"));
    CHECK_THAT(complaint({"complet"}), !Contains("'complete'"));  // it is hidden
}

TEST_CASE("help and version end with 0") {
    CHECK_THAT(ended({"--help"}).said.out, Contains("Runs:\n") && Contains("\n  run "));
    CHECK(ended({"run", "--help"}).code == 0);
    CHECK(ended({"--version"}).said.out == ended({"version"}).said.out);
}

TEST_CASE("the description of the commands has all that are not hidden, with their options") {
    const CommandLine line;
    const CommandTree tree = command_tree(line.parser());
    CHECK(tree.commands.size() + 1 == all_commands().size());
    for (const DescribedCommand& command : tree.commands) {
        INFO(command.name);
        CHECK(command.name != "complete");
        CHECK_FALSE(command.meaning.empty());
        for (const CommandOption& option : command.options) {
            CHECK_FALSE(option.meaning.empty());
            CHECK(option.value.find_first_of(":{") == option.value.find(":T]"));  // nothing of CLI11's
        }
    }
}
