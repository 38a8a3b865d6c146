#include <catch2/catch.hpp>

#include "cli/pages/made_tree.hpp"
#include "ljmd/cli/pages/completion.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

// tests/cli/pages.py drives a real bash.
TEST_CASE("the script for bash knows options and the kinds of their values") {
    const std::string script = bash_completion(made_tree());
    CHECK_THAT(script, Contains("words=\"run analyze version --help -h\""));
    CHECK_THAT(script, Contains("        run)\n            case $before in\n                --set) kind=keys ;;\n"
                                "                --simd) words=\"portable "));
    CHECK_THAT(script, Contains("--walltime) kind=nothing ;;"));
    CHECK_THAT(script, Contains("words=\"--set --quiet -q --simd --walltime\"; else kind=decks; fi"));
    CHECK_THAT(script, Contains("--out) kind=directories ;;"));
    CHECK_THAT(script, Contains("if [[ $COMP_CWORD -gt 2 ]]; then words=\"") && Contains("; else kind=files; fi"));
}
