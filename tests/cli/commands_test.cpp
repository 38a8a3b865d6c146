#include "ljmd/cli/commands.hpp"

#include "deck/deck_fixtures.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/io/tables/json_text.hpp"
#include "ljmd/run/interruption.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

DeckOptions options_of(const DeckFolder& folder) {
    return {.deck = folder.deck_path().string(), .settings = {}};
}

}  // namespace

TEST_CASE("check tells the cost of a deck and writes nothing") {
    const DeckFolder folder;
    const std::filesystem::path odd = folder / "d\xff.toml";  // no UTF-8, which JSON must be
    std::filesystem::copy(folder.deck_path(), odd);
    DeckOptions options = options_of(folder);
    options.settings = {"output.directory=\"" + (folder / "out").string() + "\""};
    const Said text = said([&] { check_command(options); });
    CHECK_THAT(text.out, Contains("the deck is good") && Contains("108"));
    CHECK(text.err.empty());
    options.json = true;
    options.deck = odd.string();
    const Data json = parse_json(said([&] { check_command(options); }).out);
    CHECK(json.at("atoms") == 108);
    CHECK(json.at("steps") == 60);
    CHECK(json.at("cutoff") == 2.0);
    CHECK(json.at("largest_cutoff").number() == Approx(2.56496).epsilon(1e-5));
    for (const char* key : {"memory_bytes", "disk_bytes", "seconds"}) {
        CHECK(json.at(key).number() > 0.0);
    }
    CHECK_FALSE(std::filesystem::exists(folder / "out"));
}

TEST_CASE("run writes its files and prints its table, or JSON") {
    const DeckFolder folder;
    DeckOptions options = options_of(folder);
    options.quiet = true;
    const std::string out = (folder / "out").string();
    const Said first = said([&] { run_command(options, out); });
    CHECK(first.out == content_of(folder / "out" / "results.txt"));
    CHECK_THROWS_AS(run_command(options, out), InputError);
    options.force = true;
    options.json = true;
    const Said second = said([&] { run_command(options, out); });
    CHECK(second.out == content_of(folder / "out" / "results.json"));
    CHECK(parse_json(second.out).at("observables").contains("temperature"));
}

TEST_CASE("resume continues a run that its wall time has stopped, in its directory") {
    const DeckFolder folder;
    DeckOptions options = options_of(folder);
    options.quiet = true;
    const std::string out = (folder / "out").string();
    CHECK_THROWS_AS(run_command(options, out, "soon"), InputError);
    static_cast<void>(said([&] { CHECK_THROWS_AS(run_command(options, out, "1e-6 s"), Interrupted); }));
    ResumeOptions resumed;
    resumed.directory = out;
    resumed.quiet = true;
    resumed.json = true;
    const Said words = said([&] { resume_command(resumed); });
    CHECK(parse_json(words.out).at("observables").contains("temperature"));
    CHECK(parse_json(content_of(folder / "out" / "run.json")).at("resumed_at_steps") == Data::list({0}));

    resumed.more_steps = 10;
    resumed.json = false;
    static_cast<void>(said([&] { resume_command(resumed); }));
    CHECK(parse_json(content_of(folder / "out" / "run.json")).at("steps_added") == 10);
    CHECK(parse_json(content_of(folder / "out" / "results.json")).at("stages").at(1).at("steps") == 50);

    resumed.directory = (folder / "nowhere").string();
    CHECK_THROWS_AS(resume_command(resumed), DataError);
}

TEST_CASE("a start that cannot be used costs an earlier run nothing") {
    const DeckFolder folder;
    DeckOptions options = options_of(folder);
    options.quiet = true;
    const std::string out = (folder / "out").string();
    static_cast<void>(said([&] { run_command(options, out); }));
    const std::string before = content_of(folder / "out" / "run.json");
    std::ofstream(folder / "start.xyz") << "1\nLattice=\"9 0 0 0 9 0 0 0 9\" Properties=species:S:1:pos:R:3\nX 0 0 0\n";
    options.force = true;
    options.settings = {"system.file=" + (folder / "start.xyz").string(), "system.velocities=file"};
    std::ofstream(folder.deck_path()) << changed(small_deck,
                                                 {{"lattice = { type = \"fcc\", cells = 3 }\ndensity = 0.8\n", ""}});
    CHECK_THROWS_AS(run_command(options, out), DataError);
    CHECK(content_of(folder / "out" / "run.json") == before);
}

TEST_CASE("a file's box is held against the deck") {
    const DeckFolder folder(
        changed(small_deck, {{"lattice = { type = \"fcc\", cells = 3 }\ndensity = 0.8\n", "file = \"\"\n"}}));
    std::ofstream(folder / "start.xyz") << "1\nLattice=\"3 0 0 0 9 0 0 0 9\" Properties=species:S:1:pos:R:3\nX 0 0 0\n";
    DeckOptions options = options_of(folder);
    options.settings = {"system.file=" + (folder / "start.xyz").string()};
    CHECK_THROWS_AS(check_command(options), InputError);
    CHECK_THROWS_WITH(check_command(options), Contains("more than half the box") && Contains("largest allowed: 1.5"));
}

TEST_CASE("warnings about a deck are told unless quiet") {
    const DeckFolder folder(changed(small_deck, {{"sample = true", "sample = true\ntemperature = 2.0"}}));
    DeckOptions options = options_of(folder);
    CHECK_THAT(said([&] { check_command(options); }).err,
               Catch::StartsWith("warning: ") && Contains("no effect without a thermostat"));
    options.quiet = true;
    CHECK(said([&] { check_command(options); }).err.empty());
}
