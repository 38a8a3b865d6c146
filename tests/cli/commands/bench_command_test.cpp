#include "cli/command_words.hpp"
#include "deck/deck_fixtures.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("bench measures the deck that it is given, and wants a fluid") {
    const DeckFolder folder;
    const std::string deck = folder.deck_path().string();
    const Data found = parse_json(said([&] { command({"bench", deck, "--json", "--quiet"}); }).out);
    CHECK(found.at("atoms") == 108);
    CHECK(found.at("steps") == 60);
    CHECK_THAT(said([&] { command({"bench", deck, "--quiet"}); }).out, Contains("million atom-steps per second"));
    const DeckFolder bodies(stars_deck);
    CHECK_THROWS_WITH(command({"bench", bodies.deck_path().string()}), Contains("wants a fluid"));
}
