#include "deck/size_forecast.hpp"

#include "deck/every_analysis.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;

namespace {

const std::string all_analyses_table = every_analysis({{"rdf", "{ every = 2 }"},
                                                       {"structure_factor", "{ every = 2 }"},
                                                       {"msd", "{ every = 1, origins = 5 }"},
                                                       {"van_hove_distinct", "{ every = 1, between = 0.2 }"},
                                                       {"chemical_potential", "{ every = 2, insertions = 10 }"}});

SizeForecast size_of(const std::vector<std::string>& settings) {
    const DeckFolder folder;
    const Deck deck = folder.load(settings);
    return forecast_size(deck, find_start(deck));
}

double bytes_in(const std::filesystem::path& directory) {
    double sum = 0.0;
    for (const auto& entry : std::filesystem::directory_iterator(directory)) {
        sum += static_cast<double>(entry.file_size());
    }
    return sum;
}

/// What an analysis keeps after all steps of a run but the last, in which windows may come to their ends.
double kept_by(Analysis& analysis, const Deck& deck, Index steps) {
    FluidSystem simulation = simulation_of(deck);
    const Evaluation evaluation = simulation.force_field.evaluate(simulation.state, Request::forces_and_energy);
    for (Index step = 0; step < steps; ++step) {
        if (analysis.due(step)) {
            analysis.sample(simulation.state, evaluation);
        }
    }
    Archive a;
    analysis.archive(a);
    return static_cast<double>(a.bytes().size());
}

}  // namespace

TEST_CASE("the disk that a run was said to need is about what it takes, checkpoints and analyses included") {
    for (const std::vector<std::string>& settings :
         {std::vector<std::string>{"output.trajectory.format=xyz", "output.trajectory.every=2"},
          {"output.trajectory.format=h5md", "output.trajectory.every=1", "output.trajectory.velocities=true"},
          {"output.thermo.every=1", "stage.production.steps=400", "system.lattice.cells=4"}}) {
        const DeckFolder folder(small_deck + argon_table + all_analyses_table);
        std::vector<std::string> with_checkpoints = settings;
        with_checkpoints.emplace_back("output.checkpoint.every=3");
        const Deck deck = folder.load(with_checkpoints);
        const double said = forecast_size(deck, find_start(deck)).disk;
        run_until(deck, total_steps(deck.stages()));
        const double taken = bytes_in(deck.directory);
        INFO(settings.front() << ": said " << said << ", taken " << taken);
        CHECK(said < 1.3 * taken);
        CHECK(said > taken / 1.3);
    }
}

TEST_CASE("what an analysis was said to keep is about what it keeps") {
    const DeckFolder folder(small_deck + all_analyses_table);
    const Deck deck = folder.load({"stage.production.steps=400"});
    SampledRun run = sampled_run(deck, 108, find_start(deck).box);
    run.interaction = fluid_spec(deck).interaction();
    for (const Choice& choice : deck.fluid().analysis.asked) {
        const ChosenAnalysis chosen = chosen_analysis(choice);
        const double said = chosen.options->size(run).kept;
        const double kept = kept_by(*chosen.options->make(run), deck, run.steps - 1);
        INFO(chosen.plugin.name << ": said " << said << ", kept " << kept);
        constexpr double counters = 1000.0;
        CHECK(said < 1.3 * kept + counters);
        CHECK(said > kept / 1.3 - counters);
    }
}

TEST_CASE("a list costs more memory than cells, mixed precision less, and all pairs least") {
    const std::string large = "system.lattice.cells=20";
    const double list = size_of({large, "neighbors.method=verlet-list"}).memory;
    const double mixed = size_of({large, "neighbors.method=verlet-list", "performance.precision=mixed"}).memory;
    const double cells = size_of({large, "neighbors.method=cells"}).memory;
    const double pairs = size_of({large, "neighbors.method=all-pairs"}).memory;
    CHECK(list > mixed);
    CHECK(mixed > cells);
    CHECK(cells > pairs);
}

TEST_CASE("memory and disk grow with atoms and frames") {
    const auto with = [](const std::string& setting) {
        return size_of(
            {"output.trajectory.every=1", "stage.production.steps=980", "output.thermo.every=1000", setting});
    };
    const SizeForecast small = with("system.lattice.cells=20");
    const SizeForecast large = with("system.lattice.cells=40");
    const double atoms = 4.0 * 20 * 20 * 20;
    CHECK(large.memory - small.memory ==
          Approx(7.0 * 300.0 * atoms).epsilon(0.1));  // runs took 250 to 318 bytes an atom
    CHECK(large.disk / small.disk == Approx(8.0).epsilon(0.01));
    // 1001 frames of three doubles an atom
    CHECK(small.disk == Approx(1001.0 * atoms * 24.0).epsilon(0.05));
}
