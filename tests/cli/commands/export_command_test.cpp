#include "cli/command_words.hpp"
#include "deck/deck_fixtures.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

// What the files hold is tried by tests/cli/exports.py and by the programs that read them.

TEST_CASE("export writes the start of a deck, and the end of a run") {
    const DeckFolder folder;
    const std::string deck = folder.deck_path().string();
    const std::string run = (folder / "out").string();
    static_cast<void>(said([&] { command({"run", deck, "--out", run, "--quiet"}); }));
    const auto exported = [&](const std::string& from, const std::string& out) {
        return parse_json(said([&] {
                              command({"export", from, "--to", "extxyz", "--out", out, "--json", "--quiet"});
                          }).out);
    };
    const Data start = exported(deck, (folder / "start").string());
    CHECK(start.at("atoms") == 108);
    CHECK(start.at("step") == 0);
    for (const Data& file : start.at("files").items()) {
        CHECK(std::filesystem::exists(file.text()));
    }
    CHECK(exported(run, (folder / "end").string()).at("step") == 60);
}

TEST_CASE("export refuses targets that there are not, and few bodies") {
    const DeckFolder folder;
    const std::string out = (folder / "out").string();
    CHECK_THROWS_AS(command({"export", folder.deck_path().string(), "--to", "gromacs", "--out", out}), InputError);
    const DeckFolder bodies(stars_deck);
    CHECK_THROWS_WITH(command({"export", bodies.deck_path().string(), "--to", "lammps", "--out", out}),
                      Contains("wants a fluid"));
    CHECK_FALSE(std::filesystem::exists(out));
}
