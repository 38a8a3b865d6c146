#include <catch2/catch.hpp>

#include "cli/pages/made_tree.hpp"
#include "ljmd/cli/pages/completion.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

// tests/cli/pages.py drives a real zsh.
TEST_CASE("the script for zsh describes each command and option") {
    const std::string script = zsh_completion(made_tree());
    CHECK_THAT(script, Catch::StartsWith("#compdef ljmd\n"));
    CHECK_THAT(script, Contains("        'analyze:look at it'\n"));
    CHECK_THAT(script, Contains("':DECK:_files -g \"*.toml(-.)\"'"));
    CHECK_THAT(script, Contains("'*--set[.toml keys\\: \\[system\\], it'\\''s \\\\n]:KEY=VALUE:_ljmd_keys'"));
    CHECK_THAT(script, Contains("'-q[no progress]'") && Contains("'--walltime[limit]:TIME: '"));
    CHECK_THAT(script, Contains("'*:ANALYSIS:(") && Contains("'--out[where to]:DIR:_files -/'"));
}
