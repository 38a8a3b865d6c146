#include "deck/few_body_check.hpp"

#include "engine/few_body_system.hpp"
#include "io/tables/json_text.hpp"
#include "run/run.hpp"
#include "run/run_directory.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

const std::string way_back =
    "\n[[stage]]\nname = \"back\"\ntime_step = 0.02\nsteps = 50\nreverse = true\nsample = false\n";

}  // namespace

TEST_CASE("the report of a few-body check tells bodies, energy, stages and disk") {
    Deck deck = DeckFolder(changed(stars_deck, {{"\n[output]", way_back + "\n[output]"}})).load();
    deck.path = "stars.toml";
    deck.directory = "runs/stars";
    const std::string report = few_body_check_report(deck).text;
    // E = 0.09 / 2 - 0.25
    CHECK_THAT(report, Catch::StartsWith("stars.toml: the deck is good. Nothing was run.\n") &&
                           Contains("2, in 2 dimensions\n") && Contains("newtonian-gravity\n") &&
                           Contains("-0.205 at the start\n") &&
                           Contains("'orbits': 95 steps of 0.01 = 0.95, velocity-verlet\n") &&
                           Contains("'back': 50 steps of 0.02 = 1, velocity-verlet, backwards\n") &&
                           Contains("runs/stars\n"));
    CHECK_THAT(few_body_check_report(DeckFolder(radial_deck).load()).text, Contains("1, in 1 dimension\n"));
}

TEST_CASE("a few-body check as JSON") {
    Deck deck = DeckFolder(stars_deck).load();
    deck.path = "d\xff.toml";  // no UTF-8, which JSON must be
    const Data json = parse_json(to_json(few_body_check_report(deck).data));
    CHECK(json.at("bodies") == 2);
    CHECK(json.at("dimensions") == 2);
    CHECK(json.at("force") == "newtonian-gravity");
    CHECK(json.at("total_energy").number() == Approx(-0.205).epsilon(1e-14));
    CHECK(json.at("steps") == 95);
}

TEST_CASE("the disk that a few-body run was said to need is about what it takes") {
    const DeckFolder folder(stars_deck);
    for (const std::vector<std::string>& settings :
         {std::vector<std::string>{"output.thermo.every=1"},
          {"output.trajectory.every=1", "output.thermo.every=500"},
          {"output.trajectory.every=2", "output.trajectory.accelerations=true", "output.thermo.every=500"}}) {
        INFO(settings.front());
        std::vector<std::string> all = settings;
        all.emplace_back("stage.orbits.steps=1000");
        const Deck deck = folder.load(all);
        const double said = few_body_check_report(deck).data.at("disk_bytes").number();
        prepare_directory(deck.directory);
        FewBodySystem system = make_few_body_system(deck.few_bodies());
        Recorder listener;
        static_cast<void>(run_plan(deck, system, listener));
        double taken = 0.0;
        for (const char* name : {"thermo.csv", "trajectory.csv"}) {
            if (std::filesystem::exists(deck.directory / name)) {
                taken += static_cast<double>(std::filesystem::file_size(deck.directory / name));
            }
        }
        CHECK(said > 0.5 * taken);
        CHECK(said < 2.0 * taken);
    }
}
