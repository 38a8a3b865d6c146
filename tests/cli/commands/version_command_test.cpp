#include "cli/command_words.hpp"
#include "deck/deck_fixtures.hpp"
#include "ljmd/core/build_info.hpp"

using namespace ljmd;
using namespace ljmd::test;

TEST_CASE("version is that of the build") {
    CHECK(said([] { command({"version"}); }).out == "ljmd " + build_info().version + "\n");
}
