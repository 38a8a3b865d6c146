#include "run/recorded_run.hpp"

#include <sys/stat.h>

#include <fstream>
#include <limits>

#include "deck/deck_fixtures.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"
#include "run/run_directory.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

/// Runs the deck in its folder; returns the directory and the state at the end.
std::pair<fs::path, State> run_in(const DeckFolder& folder, const std::vector<std::string>& settings = {}) {
    const Deck deck = folder.load(settings);
    FluidSystem simulation = simulation_of(deck);
    prepare_directory(deck.directory);
    Recorder recorder;
    static_cast<void>(run_plan(deck, simulation, recorder));
    return {deck.directory, std::move(simulation.state)};
}

Deck deck_of(const fs::path& directory, const std::vector<std::string>& settings = {}) {
    Diagnostics diagnostics;
    return recorded_deck(directory, settings, diagnostics);
}

void change_record(const fs::path& directory, const std::string& key, const Data& value) {
    Data record = parse_json(content_of(directory / "run.json"));
    record[key] = value;
    std::ofstream(directory / "run.json") << to_json(record);
}

}  // namespace

TEST_CASE("the deck of a run is the one that it was made with, whatever became of its file") {
    const DeckFolder folder;
    const auto [directory, state] = run_in(folder, {"potential.cutoff=1.5", "stage.production.time_step=0.001"});
    fs::remove(folder.deck_path());
    const Deck deck = deck_of(directory);
    CHECK(deck.potential().radius == 1.5);
    CHECK(deck.stages().at(1).time_step == 0.001);
    CHECK(deck.title == "A small liquid");
    CHECK(deck_of(directory, {"potential.cutoff=1.75"}).potential().radius == 1.75);
}

TEST_CASE("the last configuration of a run is its state, unwrapped, to the last bit") {
    const DeckFolder folder;
    const auto [directory, state] = run_in(folder);
    const State last = last_configuration(directory, deck_of(directory));
    REQUIRE(last.count() == state.count());
    CHECK(last.step == 60);
    CHECK(last.time == state.time);
    CHECK(last.box().edges() == state.box().edges());
    const std::vector<Index> index = state.index_of();
    for (Index id = 0; id < last.count(); ++id) {
        const Index i = index[static_cast<std::size_t>(id)];
        CHECK(last.unwrapped(id) == state.unwrapped(i));
        CHECK(last.velocities().col(id) == state.velocities().col(i));
    }
}

TEST_CASE("a run that was forced is taken as it is") {
    const DeckFolder folder;
    const auto [directory, state] = run_in(folder);
    change_record(directory, "settings", Data::list({"stage.production.time_step=0.03"}));
    CHECK(deck_of(directory).stages().at(1).time_step == 0.03);
}

TEST_CASE("the beginning of a run cannot be set any more, and mistakes in settings are told") {
    const DeckFolder folder;
    const auto [directory, state] = run_in(folder);
    CHECK_THROWS_AS(deck_of(directory, {"system.density=0.5"}), InputError);
    CHECK_THROWS_WITH(deck_of(directory, {"system.density=0.5"}),
                      Contains("--set system.density=0.5: [system] describes"));
    CHECK_THROWS_AS(deck_of(directory, {"potential.cutof=2"}), InputError);
    CHECK_THROWS_WITH(deck_of(directory, {"potential.cutof=2"}), Contains("unknown key 'cutof'"));
}

TEST_CASE("what is no run, or none that ended, is refused") {
    const DeckFolder folder;
    const auto [directory, state] = run_in(folder);
    const Deck deck = deck_of(directory);
    fs::remove(directory / "final.xyz");
    CHECK_THROWS_AS(last_configuration(directory, deck), DataError);
    CHECK_THROWS_WITH(last_configuration(directory, deck), Contains("no final.xyz"));
    change_record(directory, "program", "another");
    CHECK_THROWS_WITH(deck_of(directory), Contains("another program"));
    change_record(directory, "program", "ljmd");
    for (const char* kind : {"few-body", "fluids", ""}) {
        change_record(directory, "kind", kind);
        CHECK_THROWS_AS(recorded_run(directory), DataError);
        CHECK_THROWS_WITH(recorded_run(directory),
                          Contains("'kind' is ") && Contains("its deck is one of kind 'fluid'"));
    }
    change_record(directory, "kind", "fluid");
    for (const Data& threads : {Data(0), Data(-5), Data(1e300)}) {
        change_record(directory, "threads", threads);
        CHECK_THROWS_AS(recorded_run(directory), DataError);
        CHECK_THROWS_WITH(recorded_run(directory), Contains("'threads' is ") && Contains("allowed: an integer from 1"));
    }
    change_record(directory, "threads", 1);
    change_record(directory, "steps_added", std::numeric_limits<Index>::max());
    CHECK_THROWS_WITH(recorded_run(directory), Contains("'steps_added' is 9223372036854775807"));
    change_record(directory, "steps_added", 0);
    CHECK_THROWS_AS(recorded_run(directory, max_steps), InputError);
    CHECK_THROWS_WITH(recorded_run(directory, max_steps), Contains("at most 999999999"));
    change_record(directory, "deck", 7);
    CHECK_THROWS_WITH(deck_of(directory), Contains("run.json is not the record of a run"));
    std::ofstream(directory / "run.json") << "{";
    CHECK_THROWS_AS(deck_of(directory), DataError);
    fs::remove(directory / "run.json");
    fs::create_directory(directory / "run.json");
    CHECK_THROWS_WITH(deck_of(directory), Contains("run.json: is a directory, not a regular file"));
    fs::remove(directory / "run.json");
    REQUIRE(mkfifo((directory / "run.json").c_str(), 0600) == 0);
    CHECK_THROWS_WITH(deck_of(directory), Contains("run.json: is a pipe, not a regular file"));
    fs::remove(directory / "run.json");
    CHECK_THROWS_AS(deck_of(directory), DataError);
    CHECK_THROWS_WITH(deck_of(directory), Contains("is not the directory of a run: it has no run.json"));
}
