#include "run/run_record.hpp"

#include <cmath>

#include "deck/deck_fixtures.hpp"
#include "io/formats/configuration_reader.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/build_info.hpp"
#include "ljmd/detail/options/registry.hpp"
#include "run/run_directory.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

Data record_of(const Deck& deck) {
    return parse_json(content_of(deck.directory / "run.json"));
}

/// run.json as it is when a run of this deck begins.
Data first_record(const std::string& text, const std::vector<std::string>& settings = {}) {
    const DeckFolder folder(text);
    const Deck deck = folder.load(settings);
    prepare_directory(deck.directory);
    const RunRecord record(deck, Execution());
    return record_of(deck);
}

}  // namespace

TEST_CASE("run.json says what is run by what, and whether it came to its end") {
    const DeckFolder folder(small_deck + argon_table);
    const Deck deck = folder.load({"title=\"Another title\""});
    prepare_directory(deck.directory);
    RunRecord record(deck, Execution());
    const Data before = record_of(deck);
    CHECK(before.at("program") == "ljmd");
    CHECK(before.at("version") == build_info().version);
    CHECK(before.at("commit") == build_info().commit);
    CHECK_FALSE(before.at("compiler").text().empty());
    CHECK(before.at("deck") == content_of(folder.deck_path()));
    CHECK(before.at("deck_file") == folder.deck_path().string());
    CHECK(before.at("settings") == Data::list({"title=\"Another title\""}));
    CHECK(before.at("title") == "Another title");
    CHECK(before.at("kind") == "fluid");
    CHECK(before.at("seed") == 7);
    CHECK(before.at("units") == "reduced");
    CHECK(before.at("threads") == 1);
    CHECK(before.at("resumed_at_steps") == Data::list());
    CHECK(before.at("argon").at("sigma_nm").number() == Approx(0.3405).epsilon(1e-12));
    CHECK(before.at("argon").at("tau_ps").number() == Approx(2.1564).epsilon(1e-4));
    CHECK(before.at("finished") == false);
    CHECK(before.at("ended").is_null());
    CHECK(before.at("seconds_in_time_loop").is_null());

    record.finish(1.25);
    const Data after = record_of(deck);
    CHECK(after.at("finished") == true);
    CHECK(after.at("ended").text() >= after.at("began").text());
    CHECK(after.at("seconds_in_time_loop") == 1.25);
    for (const auto& [key, value] : before.members()) {
        INFO(key);
        CHECK((key == "finished" || key == "ended" || key == "seconds_in_time_loop" || after.at(key) == value));
    }
}

TEST_CASE("run.json of a few bodies has the same keys, without seed and substance") {
    const Data fluid = first_record(small_deck);
    const Data stars = first_record(stars_deck);
    CHECK(stars.at("kind") == "few-body");
    CHECK(stars.at("seed").is_null());
    CHECK(stars.at("argon").is_null());
    CHECK(stars.at("units") == "the deck's own");
    CHECK(stars.at("title") == "Two stars");
    for (const auto& [key, value] : fluid.members()) {
        INFO(key);
        CHECK(stars.contains(key));
    }
    CHECK(stars.size() == fluid.size());
    CHECK(fluid.at("digits") == "common-1");
    CHECK(stars.at("digits") == "common-1");
    CHECK(first_record(stars_deck, {"stage.orbits.integrator=prince-dormand"}).at("digits").is_null());
}

TEST_CASE("the hash tells decks apart by text and by settings") {
    const auto hash = [](const std::string& text, const std::vector<std::string>& settings) {
        return first_record(text, settings).at("deck_hash").text();
    };
    const std::string plain = hash(small_deck, {});
    CHECK(plain.size() == std::string("xxh3:0123456789abcdef").size());
    CHECK(hash(small_deck, {}) == plain);
    CHECK(hash(small_deck + "\n", {}) != plain);
    CHECK(hash(small_deck, {"system.seed=7"}) != plain);
    CHECK(hash(small_deck, {"system.seed=8"}) != hash(small_deck, {"system.seed=9"}));
}

TEST_CASE("the path of a deck need not be UTF-8") {
    const DeckFolder folder;
    Deck deck = folder.load();
    deck.path = "d\xff.toml";
    prepare_directory(deck.directory);
    const RunRecord record(deck, Execution());
    CHECK_THAT(record_of(deck).at("deck_file").text(), Contains(".toml"));
}

TEST_CASE("the trajectory that a deck asks for is opened, and none that it does not") {
    const DeckFolder folder(stars_deck);
    Deck deck = folder.load();
    prepare_directory(deck.directory);
    const State state(2);
    CHECK(open_trajectory(deck, state) == nullptr);
    CHECK(std::filesystem::is_empty(deck.directory));
    for (const std::string& format : plugin_names(all_trajectory_formats())) {
        deck.trajectory = TrajectoryOutput{format, 1};
        REQUIRE(open_trajectory(deck, state) != nullptr);
        CHECK(std::filesystem::exists(deck.directory / ("trajectory." + format)));
    }
}

TEST_CASE("a configuration that a run was given up at is kept as it is, and the user told where") {
    const DeckFolder folder;
    Deck deck = folder.load();
    FluidSystem simulation = simulation_of(deck);
    prepare_directory(deck.directory);
    const std::string file = (deck.directory / "failed.xyz").string();
    CHECK(save_failure(deck, simulation.state) == "\n  the configuration is in " + file);
    const Configuration kept = read_configuration(file, std::nullopt);
    CHECK(kept.positions.size() == 108);
    CHECK(kept.velocities.size() == 108);
    simulation.state.write_positions()(0, 0) = std::nan("");
    CHECK_FALSE(save_failure(deck, simulation.state).empty());
    CHECK_THAT(content_of(file), Contains("nan"));
    deck.directory = folder / "nowhere";
    CHECK(save_failure(deck, simulation.state).empty());
}
