#include "cli/command_words.hpp"
#include "deck/deck_fixtures.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("run writes its files and prints its table, or JSON") {
    const DeckFolder folder;
    const std::string deck = folder.deck_path().string();
    const std::string out = (folder / "out").string();
    const Said first = said([&] { command({"run", deck, "--out", out, "--quiet"}); });
    CHECK(first.out == content_of(folder / "out" / "results.txt"));
    CHECK_THROWS_AS(command({"run", deck, "--out", out, "--quiet"}), InputError);
    const Said second = said([&] { command({"run", deck, "--out", out, "--quiet", "--force", "--json"}); });
    CHECK(second.out == content_of(folder / "out" / "results.json"));
    CHECK(parse_json(second.out).at("observables").contains("temperature"));
}

TEST_CASE("a start that cannot be used costs an earlier run nothing") {
    const DeckFolder folder;
    const std::string deck = folder.deck_path().string();
    const std::string out = (folder / "out").string();
    static_cast<void>(said([&] { command({"run", deck, "--out", out, "--quiet"}); }));
    const std::string before = content_of(folder / "out" / "run.json");
    std::ofstream(folder / "start.xyz") << "1\nLattice=\"9 0 0 0 9 0 0 0 9\" Properties=species:S:1:pos:R:3\nX 0 0 0\n";
    std::ofstream(folder.deck_path()) << changed(small_deck,
                                                 {{"lattice = { type = \"fcc\", cells = 3 }\ndensity = 0.8\n", ""}});
    CHECK_THROWS_AS(command({"run", deck, "--out", out, "--quiet", "--force", "--set",
                             "system.file=" + (folder / "start.xyz").string(), "--set", "system.velocities=file"}),
                    DataError);
    CHECK(content_of(folder / "out" / "run.json") == before);
}

// Replicas are run by the tests in tests/cli/until.py: they are processes of the program.
TEST_CASE("replicas that are wrong touch nothing") {
    const DeckFolder folder;
    const std::string deck = folder.deck_path().string();
    const std::string out = (folder / "out").string();
    const auto replicas = [&](const std::string& of, const std::vector<std::string>& more = {}) {
        std::vector<std::string> words{"run", of, "--out", out, "--replicas", "2", "--jobs", "1"};
        words.insert(words.end(), more.begin(), more.end());
        command(words);
    };
    CHECK_THROWS_WITH(replicas(deck + "x"), Contains("no such file"));
    CHECK_THROWS_WITH(replicas(deck, {"--set", "system.densty=1"}), Contains("unknown key 'densty'"));
    const DeckFolder bodies(stars_deck);
    CHECK_THROWS_WITH(replicas(bodies.deck_path().string()), Contains("a motion of few bodies has none"));
    CHECK_THROWS_AS(replicas(deck, {"--threads", "2"}), CLI::ParseError);
    CHECK_FALSE(std::filesystem::exists(out));
}
