#include <catch2/catch.hpp>

#include "cli/pages/made_tree.hpp"
#include "ljmd/cli/pages/completion.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

// tests/cli/pages.py asks a real fish.
TEST_CASE("the script for fish has a line for each command and option") {
    const std::string script = fish_completion(made_tree());
    const std::string of_run = "complete -c ljmd -n '__fish_seen_subcommand_from run'";
    CHECK_THAT(script, Contains("complete -c ljmd -n __fish_use_subcommand -a analyze -d 'look at it'\n"));
    CHECK_THAT(script, Contains("complete -c ljmd -n __fish_use_subcommand -l help -s h -d 'this text'\n"));
    CHECK_THAT(script, Contains(of_run + " -a '(__fish_complete_suffix .toml)'\n"));
    CHECK_THAT(script, Contains(of_run + " -l set -x -a '(__ljmd_keys)' -d '.toml keys: [system], it\\'s \\\\n'\n"));
    CHECK_THAT(script, Contains(of_run + " -l walltime -x -d 'limit'\n"));
}
