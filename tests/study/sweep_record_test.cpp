#include "study/sweep_record.hpp"

#include "io/files/claimed_file.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

SweepPlan plan(const std::vector<std::vector<std::string>>& values = {{"1"}, {"2"}}) {
    return {"deck.toml", small_deck, {"system.seed=3"}, {{"system.temperature"}, values}};
}

/// A run of that point, stopped in the middle.
void leave_run(const ChildRun& run) {
    Diagnostics diagnostics;
    auto deck = load_deck_text("deck.toml", run.source, run.settings, false, diagnostics);
    REQUIRE(deck.has_value());
    deck->directory = run.directory;
    run_until(*deck, 30);
    std::ofstream(run.log) << "stopped\n";
}

}  // namespace

TEST_CASE("a sweep has a run for each point, from a copy of its deck") {
    const TemporaryFolder folder;
    const fs::path out = folder / "";
    prepare_sweep(plan(), out, false);
    CHECK(content_of(out / "points" / "deck.toml") == small_deck);
    const auto runs = sweep_runs(plan(), out);
    REQUIRE(runs.size() == 2);
    CHECK(runs[1].name == "temperature=2");
    CHECK(runs[1].settings == std::vector<std::string>{"system.seed=3", "system.temperature=2"});
    CHECK(runs[1].directory == out / "points" / "temperature=2");
    CHECK(runs[1].deck == out / "points" / "deck.toml");
    CHECK(runs[1].source == small_deck);
    const auto record = parse_json(content_of(out / "sweep.json"));
    CHECK(record["program"] == "ljmd");
    CHECK(record["deck"] == small_deck);
    CHECK(record["keys"] == std::vector<std::string>{"system.temperature"});
    CHECK(record["points"][1]["name"] == "temperature=2");
    CHECK(record["points"][1]["values"] == std::vector<std::string>{"2"});
}

TEST_CASE("the same sweep is taken again, another one is refused and changes nothing") {
    const TemporaryFolder folder;
    const fs::path out = folder / "";
    prepare_sweep(plan(), out, false);
    leave_run(sweep_runs(plan(), out)[0]);
    const std::string before = content_of(out / "sweep.json");
    SweepPlan moved = plan();
    moved.deck_file = "elsewhere/deck.toml";  // the same text is the same deck
    prepare_sweep(moved, out, false);
    prepare_sweep(plan(), out, false);

    SweepPlan deck = plan();
    deck.deck += "\n";
    SweepPlan settings = plan();
    settings.settings.clear();
    SweepPlan keys = plan();
    keys.points.keys = {"system.density"};
    CHECK_THROWS_WITH(prepare_sweep(deck, out, false), Contains("holds a sweep with another deck. Nothing was run."));
    CHECK_THROWS_WITH(prepare_sweep(settings, out, false), Contains("holds a sweep with other settings (--set)."));
    for (const SweepPlan& other : {keys, plan({{"1"}}), plan({{"2"}, {"1"}}), plan({{"1"}, {"2"}, {"3"}})}) {
        CHECK_THROWS_WITH(prepare_sweep(other, out, false), Contains("holds a sweep with other points."));
    }
    CHECK(content_of(out / "sweep.json") == before);
    CHECK(fs::exists(out / "points" / "temperature=1" / "run.json"));
}

TEST_CASE("force removes what another sweep wrote, but for common runs and the files of others") {
    const TemporaryFolder folder;
    const fs::path out = folder / "";
    prepare_sweep(plan({{"1"}, {"2"}, {"3"}}), out, false);
    for (const ChildRun& run : sweep_runs(plan({{"1"}, {"2"}, {"3"}}), out)) {
        leave_run(run);
    }
    std::ofstream(out / "sweep.csv") << "old\n";
    std::ofstream(out / "points" / "temperature=2" / "notes.txt") << "mine\n";
    const std::string kept = content_of(out / "points" / "temperature=1" / "run.json");
    prepare_sweep(plan({{"1"}, {"4"}}), out, true);
    CHECK(content_of(out / "points" / "temperature=1" / "run.json") == kept);
    CHECK(content_of(out / "points" / "temperature=2" / "notes.txt") == "mine\n");
    CHECK_FALSE(fs::exists(out / "points" / "temperature=2" / "run.json"));
    CHECK_FALSE(fs::exists(out / "points" / "temperature=2.log"));
    CHECK_FALSE(fs::exists(out / "points" / "temperature=3"));
    CHECK_FALSE(fs::exists(out / "sweep.csv"));
    prepare_sweep(plan({{"1"}, {"4"}}), out, false);  // it is this one's now

    SweepPlan other_deck = plan({{"1"}, {"4"}});
    other_deck.deck += "\n";
    prepare_sweep(other_deck, out, true);
    CHECK_FALSE(fs::exists(out / "points" / "temperature=1"));
}

TEST_CASE("while workers run points, no other sweep takes their directory") {
    const TemporaryFolder folder;
    const fs::path out = folder / "";
    prepare_sweep(plan(), out, false);
    const SweepPlan other = plan({{"1"}, {"3"}});
    std::optional<SharedDirectory> worker(out / "points");
    CHECK_NOTHROW(prepare_sweep(plan(), out, false));
    const std::string before = content_of(out / "sweep.json");
    CHECK_THROWS_AS(prepare_sweep(other, out, true), InUseError);
    CHECK(content_of(out / "sweep.json") == before);
    worker.reset();
    prepare_sweep(other, out, true);
    CHECK(content_of(out / "sweep.json") != before);
}

TEST_CASE("runs are waited for when nothing else is in the way, and before they are removed") {
    const TemporaryFolder folder;
    const fs::path out = folder / "";
    const auto never = [](const fs::path&) { FAIL("nothing is to be waited for"); };
    prepare_sweep(plan(), out, false, never);
    leave_run(sweep_runs(plan(), out)[1]);
    const SweepPlan other = plan({{"1"}, {"3"}});
    CHECK_THROWS_AS(prepare_sweep(other, out, false, never), InputError);
    {
        const SharedDirectory worker(out / "points");
        CHECK_THROWS_AS(prepare_sweep(other, out, true, never), InUseError);
    }
    fs::create_directories(out / "sweep.csv");
    CHECK_THROWS_AS(prepare_sweep(other, out, true, never), InputError);
    fs::remove(out / "sweep.csv");
    prepare_sweep(plan(), out, true, never);  // the same one replaces nothing
    int waited = 0;
    prepare_sweep(other, out, true, [&](const fs::path& points) {
        ++waited;
        CHECK(points == out / "points");
        CHECK(fs::exists(points / "temperature=2" / "run.json"));
    });
    CHECK(waited == 1);
    CHECK_FALSE(fs::exists(out / "points" / "temperature=2" / "run.json"));
}

TEST_CASE("a sweep that failed before its record was written can be given again") {
    const TemporaryFolder folder;
    fs::create_directory(folder / "points");
    prepare_sweep(plan(), folder / "", false);
    CHECK(fs::exists(folder / "sweep.json"));
}

TEST_CASE("what no sweep has written is not touched, with force or without") {
    for (const char* name : {"points", "sweep.csv"}) {
        const TemporaryFolder folder;
        fs::create_directories(folder / name / "kept");
        for (const bool force : {false, true}) {
            CHECK_THROWS_WITH(prepare_sweep(plan(), folder / "", force), Contains("but no sweep. Nothing was run."));
        }
        CHECK(folder.count_files() == 1);
        CHECK(fs::is_directory(folder / name / "kept"));
    }
    const TemporaryFolder folder;
    prepare_sweep(plan(), folder / "", false);
    leave_run(sweep_runs(plan({{"1"}}), folder / "")[0]);
    fs::rename(folder / "points/temperature=1", folder / "points/temperature=2");
    CHECK_THROWS_WITH(prepare_sweep(plan(), folder / "", false),
                      Contains("temperature=2 holds a run that is not of this"));
    prepare_sweep(plan(), folder / "", true);
}

TEST_CASE("a record that is damaged is told of") {
    for (
        const char* text :
        {"", "[]", "{\"deck\": 1}",
         R"({"deck_file": "", "deck": "", "settings": [], "keys": ["a"], "points": [{"values": []}]})",
         R"({"deck_file": "", "deck": "", "settings": [], "keys": ["a"], "points": 3})",
         R"({"deck_file": "", "deck": "", "settings": [], "keys": ["a"], "points": []})",
         R"({"deck_file": "", "deck": "", "settings": [], "keys": [], "points": [{"values": []}]})",
         R"({"deck_file": "", "deck": "", "settings": [], "keys": ["a"], "points": [{"values": [""]}]})",
         R"({"deck_file": "", "deck": "", "settings": [], "keys": ["a"], "points": [{"values": ["1"]}, {"values": ["1"]}]})"}) {
        INFO(text);
        const TemporaryFolder folder;
        std::ofstream(folder / "sweep.json") << text;
        CHECK_THROWS_AS(prepare_sweep(plan(), folder / "", true), DataError);
        CHECK(content_of(folder / "sweep.json") == text);
    }
}

TEST_CASE("keys that no deck has are refused in a record as they are in --grid") {
    for (const char* key : {"", ".", "a..b", ".a", "a.", "'a", "a=b", " "}) {
        INFO(key);
        const TemporaryFolder folder;
        std::ofstream(folder / "sweep.json") << R"({"deck_file": "", "deck": "", "settings": [], "keys": [")" << key
                                             << R"("], "points": [{"values": ["1"]}]})";
        CHECK_THROWS_WITH(recorded_sweep(folder / ""),
                          Contains("sweep.json is not the record of a sweep: ") && Contains("is no key of a deck"));
    }
    const TemporaryFolder folder;
    std::ofstream(folder / "sweep.json")
        << R"({"deck_file": "", "deck": "", "settings": ["a=1"], "keys": ["a"], "points": [{"values": ["1"]}]})";
    CHECK_THROWS_WITH(recorded_sweep(folder / ""), Contains("'a' is varied, and given by --set as well"));
}
