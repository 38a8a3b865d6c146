#include "ljmd/app/forecast.hpp"

#include <cmath>

#include "app/app_fixtures.hpp"
#include "ljmd/app/run.hpp"
#include "ljmd/app/run_directory.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

Forecast forecast_of(const std::vector<std::string>& settings) {
    const DeckFolder folder;
    const Deck deck = folder.load(settings);
    return forecast(deck, find_start(deck));
}

}  // namespace

TEST_CASE("memory grows with the number of atoms, disk with atoms and frames") {
    const std::vector<std::string> base{"output.trajectory.every=1", "stage.production.steps=980",
                                        "output.thermo.every=1000"};
    const auto with = [&](const std::string& setting) {
        std::vector<std::string> settings = base;
        settings.push_back(setting);
        return forecast_of(settings);
    };
    const Forecast small = with("system.lattice.cells=20");
    const Forecast large = with("system.lattice.cells=40");
    const double atoms = 4.0 * 20 * 20 * 20;
    CHECK(small.memory_bytes > 300.0 * atoms);  // runs took 530 bytes an atom of 32000, and 460 of 256000
    CHECK(small.memory_bytes < 600.0 * atoms);
    CHECK(large.memory_bytes / small.memory_bytes > 7.0);  // 8 times the atoms, and the program once
    CHECK(large.memory_bytes / small.memory_bytes <= 8.0);
    CHECK(large.disk_bytes / small.disk_bytes == Approx(8.0).epsilon(0.01));
    // 1001 frames of three doubles an atom
    CHECK(small.disk_bytes == Approx(1001.0 * atoms * 24.0).epsilon(0.05));
    CHECK(small.seconds > 0.0);
    CHECK(std::isfinite(small.seconds));
}

TEST_CASE("a list costs more memory than cells, and all pairs least") {
    const double list = forecast_of({"neighbors.method=verlet-list"}).memory_bytes;
    const double cells = forecast_of({"neighbors.method=cells"}).memory_bytes;
    const double pairs = forecast_of({"neighbors.method=all-pairs"}).memory_bytes;
    CHECK(list > cells);
    CHECK(cells > pairs);
}

TEST_CASE("the disk that a run was said to need is about what it takes") {
    for (const char* format : {"xyz", "h5md"}) {
        const DeckFolder folder(small_deck + argon_table);
        const Deck deck =
            folder.load({"output.thermo.every=1", "output.trajectory.every=2", "output.trajectory.velocities=true",
                         std::string("output.trajectory.format=") + format});
        const Forecast said = forecast(deck, find_start(deck));
        Simulation simulation = simulation_of(deck);
        prepare_directory(deck.directory);
        struct Nobody : RunListener {
        } listener;
        static_cast<void>(run_deck(deck, simulation, listener));
        double taken = 0.0;
        for (const char* name : {"thermo.csv", "final.xyz"}) {
            taken += static_cast<double>(std::filesystem::file_size(deck.directory / name));
        }
        taken +=
            static_cast<double>(std::filesystem::file_size(deck.directory / (std::string("trajectory.") + format)));
        INFO(format << ": said " << said.disk_bytes << ", taken " << taken);
        CHECK(said.disk_bytes > 0.6 * taken);
        CHECK(said.disk_bytes < 1.5 * taken);
    }
}

TEST_CASE("any start can be told the cost of, also one that no crystal of the deck's fits") {
    for (const std::vector<std::string>& settings :
         {std::vector<std::string>{"system.lattice.cells=1", "potential.cutoff=0.8"},
          {"system.density=1e-6", "potential.cutoff=20"},
          {"system.temperature=49", "stage.equilibrate.steps=0", "stage.production.steps=0"},
          {"system.lattice.cells=10", "potential.cutoff=8"}}) {
        INFO(settings.back());
        const Forecast cost = forecast_of(settings);
        CHECK((std::isfinite(cost.seconds) && cost.seconds > 0.0));
        CHECK((std::isfinite(cost.memory_bytes) && cost.memory_bytes > 0.0));
        CHECK((std::isfinite(cost.disk_bytes) && cost.disk_bytes > 0.0));
    }
}

TEST_CASE("the report of a check tells atoms, box, stages and cost") {
    const DeckFolder folder;
    const Deck deck = folder.load();
    const std::string text = check_report(deck, find_start(deck), {2.5e9, 3.4e6, 5400.0});
    CHECK_THAT(text, Catch::StartsWith(deck.path + ": the deck is good. Nothing was run.\n"));
    CHECK_THAT(text, Contains("atoms     108\n"));
    CHECK_THAT(text, Contains("5.12993 x 5.12993 x 5.12993 sigma^3, density 0.8 sigma^-3"));
    CHECK_THAT(text, Contains("cutoff    2 sigma, at most L/2 = 2.56496\n"));
    CHECK_THAT(text, Contains("'equilibrate': 20 steps of 0.004 tau = 0.08 tau\n"));
    CHECK_THAT(text, Contains("'production': 40 steps of 0.004 tau = 0.16 tau, sampled\n"));
    CHECK_THAT(text, Contains("about 2.5 GB") && Contains("about 3.4 MB in " + deck.directory.string()) &&
                         Contains("about 90 min"));
    const std::string small = check_report(deck, find_start(deck), {2.5e4, 999e3, 1.2});
    CHECK_THAT(small, Contains("about 25 kB") && Contains("about 999 kB") && Contains("about 2 s"));
    CHECK_THAT(check_report(deck, find_start(deck), {1.0, 1.0, 9000.0}), Contains("about 2.5 h"));
}
