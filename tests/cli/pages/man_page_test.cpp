#include "cli/pages/man_page.hpp"

#include "catch.hpp"

#include "cli/pages/made_tree.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("the manual page has every command with its arguments and options, and escapes what roff would obey") {
    const std::string page = man_page(made_tree());
    CHECK_THAT(page,
               Catch::StartsWith(".TH LJMD 1 \"\" \"ljmd 1.2\" \"User Commands\"\n.SH NAME\nljmd \\- a program's"));
    CHECK_THAT(page, Contains(".SS run\n\\fBljmd run\\fR \\fIDECK\\fR [\\fIOPTIONS\\fR]\n.PP\nrun a deck.\n"));
    CHECK_THAT(page, Contains("\\fIRUNDIR|TRAJECTORY\\fR [\\fIANALYSIS\\fR ...]"));
    CHECK_THAT(page, Contains(".TP\n\\fB\\-\\-quiet\\fR, \\fB\\-q\\fR\nno progress\n"));
    CHECK_THAT(page, Contains(".TP\n\\fB\\-\\-set\\fR \\fIKEY=VALUE\\fR\n\\&.toml keys: [system], it's \\en\n"));
    CHECK_THAT(page, Contains(".SH EXIT STATUS\n") && Contains("LJMD_SIMD"));
}
