#include "cli/command_words.hpp"
#include "cli/example_decks.hpp"
#include "deck/deck_fixtures.hpp"
#include "ljmd/core/errors.hpp"
#include "run/output_guard.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("init writes an example, and says how it is run") {
    const DeckFolder folder;
    const std::string file = (folder / "new.toml").string();
    CHECK_THAT(said([&] {
                   command({"init", file});
               }).out,
               Catch::StartsWith(file + ": the example 'first'\n") && Contains("ljmd run " + file));
    CHECK(content_of(file) == example_deck("first").text);
    CHECK_THROWS_AS(command({"init", file, "--example", "pendulum"}), OutputRefused);
    CHECK(content_of(file) == example_deck("first").text);
    static_cast<void>(said([&] { command({"init", file, "--example", "pendulum", "--force"}); }));
    CHECK(content_of(file) == example_deck("pendulum").text);
}

TEST_CASE("a directory is no file for a deck, even with force") {
    const DeckFolder folder;
    std::filesystem::create_directory(folder / "sub");
    CHECK_THROWS_AS(command({"init", (folder / "sub").string(), "--force"}), InputError);
    CHECK_THROWS_AS(command({"init", (folder / "sub").string() + "/", "--force"}), InputError);
}

TEST_CASE("init lists its examples with their titles") {
    CHECK_THAT(said([&] { command({"init", "--list"}); }).out, Contains("\nmelt-32k") && Contains("  A pendulum\n"));
}
