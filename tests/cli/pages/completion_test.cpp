#include "cli/pages/completion.hpp"

#include "catch.hpp"

#include "cli/pages/made_tree.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

std::string complete(const std::vector<std::string>& words) {
    return completions(made_tree(), words);
}

}  // namespace

TEST_CASE("commands come first, then their options and arguments") {
    CHECK(complete({""}) ==
          "--help\tthis text\n-h\tthis text\nrun\trun a deck\nanalyze\tlook at it\nversion\tits number\n");
    CHECK(complete({}) == complete({""}));
    CHECK(complete({"ru"}) == "run\trun a deck\n");
    CHECK(complete({"run", "--q"}) == "--quiet\tno progress\n");
    CHECK(complete({"run", ""}) == ":decks\t\n");
    CHECK(complete({"run", "a.toml", ""}).empty());
    CHECK(complete({"version", ""}).empty());
    CHECK(complete({"no-command", ""}).empty());
}

TEST_CASE("values of options are known by the words that the help has for them") {
    CHECK_THAT(complete({"run", "--simd", ""}), StartsWith("portable\t\n"));
    CHECK_THAT(complete({"run", "--simd=port"}), StartsWith("--simd=portable\t\n"));
    CHECK(complete({"run", "--walltime", ""}).empty());
    CHECK(complete({"analyze", "--out", ""}) == ":directories\t\n");
    CHECK(complete({"analyze", "--out=ru"}) == ":directories\t\n");
}

TEST_CASE("each argument has its own values, and the last may be repeated") {
    CHECK(complete({"analyze", ""}) == ":files\t\n");
    CHECK(complete({"analyze", "--out", "there", ""}) == ":files\t\n");
    CHECK(complete({"analyze", "runs", "struc"}) == "structure_factor\t\n");
    CHECK(complete({"analyze", "runs", "rdf", "structure_"}) == "structure_factor\t\n");
}

TEST_CASE("keys of decks of both kinds are completed with their equals sign, tables are not") {
    for (const char* key : {"system.density=", "stage.NAME.time_step=", "body.NUMBER.mass=", "output.thermo.every="}) {
        CHECK(complete({"run", "--set", key}) == std::string(key) + "\t\n");
    }
    CHECK_THAT(complete({"run", "--set", "system."}), !Contains("system.\t") && !Contains("system.=\t"));
}

TEST_CASE("each shell has its own script, and no other one has any") {
    CHECK_THAT(std::string(completion_script("bash")), Contains("complete -F _ljmd ljmd"));
    CHECK_THAT(std::string(completion_script("fish")), Contains("complete -c ljmd"));
    CHECK_THAT(std::string(completion_script("zsh")), StartsWith("#compdef ljmd\n"));
    CHECK_THROWS_AS(completion_script("tcsh"), InputError);
}
