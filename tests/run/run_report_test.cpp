#include "run/run_report.hpp"

#include "deck/deck_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

const StageResult there{"there", "bit-reversible", 0, 40, 0.004, true, false, false, -1.5e-7, "xxh3:a", "xxh3:b"};
const StageResult back{"back", "velocity-verlet", 40, 100, 0.002, false, true, true, std::nullopt, "xxh3:b", "xxh3:a"};

}  // namespace

TEST_CASE("a title cannot write what it likes to a terminal, and a run without one goes by its deck") {
    const DeckFolder folder;
    Deck deck = folder.load();
    CHECK(title_line(deck) == "A small liquid");
    deck.title = "a\033[2Jb\nc";
    CHECK(title_line(deck) == "a?[2Jb?c");
    deck.title = std::string(1000, 'x');
    CHECK(title_line(deck).size() < 250);
    deck.title.clear();
    CHECK(title_line(deck) == deck.path);
}

TEST_CASE("a stage in results.json has everything that is known of it") {
    CHECK(stage_data(there) == Data::object({{"name", "there"},
                                             {"integrator", "bit-reversible"},
                                             {"first_step", 0},
                                             {"last_step", 40},
                                             {"steps", 40},
                                             {"time_step", 0.004},
                                             {"sampled", true},
                                             {"thermostat", false},
                                             {"reversed", false},
                                             {"energy_drift", -1.5e-7},
                                             {"time_step_error", nullptr},
                                             {"checksum_at_start", "xxh3:a"},
                                             {"checksum_at_end", "xxh3:b"}}));
    const Data json = stage_data(back);
    CHECK(json.at("steps") == 60);
    CHECK(json.at("sampled") == false);
    CHECK(json.at("thermostat") == true);
    CHECK(json.at("reversed") == true);
    CHECK(json.at("energy_drift").is_null());
}

TEST_CASE("a time step that is too long stands in results.json") {
    StageResult stage = there;
    stage.time_step_error = 0.016;
    stage.time_step_remark = "too long";
    CHECK(stage_data(stage).at("time_step_error") == 0.016);
    CHECK(stage_data(stage).at("time_step_remark") == "too long");
}

TEST_CASE("the table tells of drifts, and of checksums when the motion was turned round") {
    CHECK(stage_lines({there}, "per hour") == "  energy drift in stage 'there': -1.5e-07 per hour\n");
    StageResult hot = there;
    hot.drift_remark = "too much";
    CHECK(stage_data(hot).at("energy_drift_remark") == "too much");
    StageResult forth = back;
    forth.reversed = false;
    CHECK(stage_lines({forth}, "per hour").empty());
    const std::string both = stage_lines({there, back}, "per hour");
    CHECK_THAT(both, Contains("xxh3:a at the start\n") && Contains("xxh3:b after stage 'there'\n") &&
                         Contains("xxh3:a after stage 'back'\n"));
}
