#include "cli/command_words.hpp"
#include "deck/deck_fixtures.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("check tells the cost of a deck and writes nothing") {
    const DeckFolder folder;
    const std::filesystem::path odd = folder / "d\xff.toml";  // no UTF-8, which JSON must be
    std::filesystem::copy(folder.deck_path(), odd);
    const std::string elsewhere = "output.directory=\"" + (folder / "out").string() + "\"";
    const Said text = said([&] { command({"check", folder.deck_path().string(), "--set", elsewhere}); });
    CHECK_THAT(text.out, Contains("the deck is good") && Contains("108"));
    CHECK(text.err.empty());
    const Data json = parse_json(said([&] { command({"check", odd.string(), "--set", elsewhere, "--json"}); }).out);
    CHECK(json.at("atoms") == 108);
    CHECK(json.at("steps") == 60);
    CHECK(json.at("cutoff") == 2.0);
    CHECK(json.at("largest_cutoff").number() == Approx(2.56496).epsilon(1e-5));
    for (const char* key : {"memory_bytes", "disk_bytes", "seconds"}) {
        CHECK(json.at(key).number() > 0.0);
    }
    CHECK_FALSE(std::filesystem::exists(folder / "out"));
}

TEST_CASE("a file's box is held against the deck") {
    const DeckFolder folder(
        changed(small_deck, {{"lattice = { type = \"fcc\", cells = 3 }\ndensity = 0.8\n", "file = \"\"\n"}}));
    std::ofstream(folder / "start.xyz") << "1\nLattice=\"3 0 0 0 9 0 0 0 9\" Properties=species:S:1:pos:R:3\nX 0 0 0\n";
    const auto check = [&] {
        command({"check", folder.deck_path().string(), "--set", "system.file=" + (folder / "start.xyz").string()});
    };
    CHECK_THROWS_AS(check(), InputError);
    CHECK_THROWS_WITH(check(), Contains("more than half the box") && Contains("largest allowed: 1.5"));
}

TEST_CASE("warnings about a deck are told unless quiet") {
    const DeckFolder folder(changed(small_deck, {{"sample = true", "sample = true\ntemperature = 2.0"}}));
    const std::string deck = folder.deck_path().string();
    CHECK_THAT(said([&] {
                   command({"check", deck});
               }).err,
               Catch::StartsWith("warning: ") && Contains("no effect without a thermostat"));
    CHECK(said([&] { command({"check", deck, "--quiet"}); }).err.empty());
}
