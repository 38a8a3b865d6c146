#include "cli/command_words.hpp"
#include "deck/deck_fixtures.hpp"
#include "io/tables/json_text.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

// That wrong digits are told is tried in tests/engine/verification.
TEST_CASE("verify compares the digits of its runs with those of this version") {
    const Data found = parse_json(said([] { command({"verify", "--simd", "portable", "--json"}); }).out);
    CHECK(found.at("right") == true);
    for (const Data& run : found.at("runs").items()) {
        CHECK(run.at("found") == run.at("wanted"));
    }
    CHECK_THROWS_AS(command({"verify", "--threads", "0"}), CLI::ParseError);
}
