#include "ljmd/engine/simulation.hpp"

#include "catch.hpp"

#include <functional>
#include <limits>
#include <stdexcept>

#include "engine/engine_fixtures.hpp"
#include "ljmd/core/errors.hpp"
#include "model/checksum.hpp"
#include "run/run_directory.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

/// Counts its calls, and adds up what it sees.
class Watcher : public Observer {
  public:
    explicit Watcher(Index every, bool energy = false) : every_(every), energy_(energy) {}
    [[nodiscard]] bool needs(Index step) const override { return step % every_ == 0; }
    [[nodiscard]] bool needs_energy() const override { return energy_; }
    void sample(const Snapshot& snapshot) override {
        steps.push_back(snapshot.step());
        sum += snapshot.unwrapped().sum();
        if (energy_) {
            sum += snapshot.thermodynamics().potential_energy;
        }
    }
    void interrupt() override { ++interruptions; }
    void archive(Archive& a) override { a(steps, sum, interruptions); }

    std::vector<Index> steps;
    double sum = 0.0;
    int interruptions = 0;

  private:
    Index every_;
    bool energy_;
};

}  // namespace

TEST_CASE("a run in memory has the bits of the same run with a deck and a directory") {
    const DeckFolder folder(small_deck + "[analysis]\nrdf = { every = 5 }\nmsd = { max_time = 0.08, every = 1 }\n");
    const Deck deck = folder.load();
    prepare_directory(deck.directory);
    FluidSystem fluid = simulation_of(deck);
    Recorder nobody;
    const RunResult with_files = run_plan(deck, fluid, nobody);

    FluidSpec spec = with_analyses();
    spec.analyses = {analysis("msd", {{"max_time", 0.08}, {"every", 1}}), analysis("rdf", {{"every", 5}})};
    Simulation simulation(spec);
    const RunResult in_memory = simulation.run();
    CHECK(simulation.finished());
    CHECK(checksum(simulation.state()) == checksum(fluid.state));
    CHECK(in_memory.last.pressure == with_files.last.pressure);
    REQUIRE(in_memory.averages.size() == with_files.averages.size());
    for (const ObservableAverage& average : with_files.averages) {
        INFO(average.name);
        if (average.estimate) {
            CHECK(in_memory.observable(average.name).estimate->mean == average.estimate->mean);
        }
    }
    CHECK(in_memory.table("rdf").rows == with_files.table("rdf").rows);
    CHECK(in_memory.stages.back().checksum_at_end == with_files.stages.back().checksum_at_end);
    CHECK(simulation.samples().size() == rows(content_of(deck.directory / "thermo.csv")).size());
    CHECK(simulation.samples().back().step == 60);
}

TEST_CASE("steps in pieces are the steps of one run") {
    Simulation whole(with_analyses());
    whole.run();
    Simulation pieces(with_analyses());
    for (const Index steps : {0, 1, 6, 13, 1, 30}) {  // the first stage ends within them, exactly
        pieces.advance(steps);
        CHECK_FALSE(pieces.finished());
    }
    CHECK(pieces.state().step == 51);
    CHECK(pieces.result().stages.back().last_step == 51);
    pieces.advance(std::numeric_limits<Index>::max());
    CHECK(pieces.finished());
    CHECK(pieces.state().step == 60);
    check_same(pieces, whole);
    pieces.advance(5);
    check_same(pieces, whole);
    CHECK_THROWS_WITH(pieces.advance(-1), "-1 steps: allowed are 0 and more");
    CHECK_THROWS_AS(pieces.advance(-1), InputError);
}

TEST_CASE("who takes all steps comes to the end, also where the last stages have none") {
    FluidSpec spec = with_analyses();
    const Index steps = total_steps(spec.stages);
    spec.stages.push_back({.name = "nothing", .steps = 0});
    Simulation simulation(spec);
    simulation.advance(steps - 1);
    CHECK_FALSE(simulation.finished());
    simulation.advance(1);
    CHECK(simulation.finished());
    CHECK(simulation.result().stages.size() == spec.stages.size());
}

TEST_CASE("a simulation that is continued from a checkpoint has the bits of one that was not interrupted") {
    Simulation whole(with_analyses());
    Watcher all(3, true);
    whole.add(all);
    whole.run();
    for (const Index step : {0, 7, 20, 41, 60}) {
        INFO(step);
        Simulation first(with_analyses());
        Watcher before(3, true);
        first.add(before);
        first.advance(step);
        Simulation second(with_analyses());
        Watcher after(3, true);
        second.add(after);
        second.restore(first.checkpoint());
        CHECK(second.state().step == step);
        second.run();
        check_same(second, whole);
        CHECK(after.steps == all.steps);
        CHECK(after.sum == all.sum);
    }
}

TEST_CASE("a checkpoint of another simulation, or a damaged one, is refused") {
    Simulation first(small_spec());
    first.advance(30);
    const std::string checkpoint = first.checkpoint();
    FluidSpec other = small_spec();
    other.start = LatticeStart{.lattice = Lattice::fcc, .cells = 4};
    CHECK_THROWS_AS(Simulation(other).restore(checkpoint), CheckpointError);
    FluidSpec renamed = small_spec();
    renamed.stages[1].name = "sampling";
    CHECK_THROWS_AS(Simulation(renamed).restore(checkpoint), CheckpointError);
    CHECK_THROWS_AS(Simulation(small_spec()).restore(""), CheckpointError);
    CHECK_THROWS_AS(Simulation(small_spec()).restore(checkpoint.substr(0, checkpoint.size() / 2)), CheckpointError);
    CHECK_THROWS_AS(Simulation(small_spec()).restore(checkpoint + "x"), CheckpointError);
    for (std::size_t k = 0; k < checkpoint.size(); k += checkpoint.size() / 50) {
        std::string damaged = checkpoint;
        damaged[k] = static_cast<char>(damaged[k] ^ 1);
        CHECK_THROWS_WITH(Simulation(small_spec()).restore(damaged), Contains("is damaged"));
    }
}

TEST_CASE("a checkpoint continues the same specification and precision only") {
    Simulation first(small_spec());
    first.advance(30);
    const std::string checkpoint = first.checkpoint();
    const std::vector<std::function<void(FluidSpec&)>> changes{
        [](FluidSpec& s) { s.potential = PairPotential::lennard_jones("shifted", s.potential.cutoff()); },
        [](FluidSpec& s) {
            s.potential = PairPotential::lennard_jones("force-shifted", {1.9, 0.0});
        }};
    for (const auto& change : changes) {
        FluidSpec other = small_spec();
        change(other);
        Simulation simulation(other);
        CHECK_THROWS_WITH(simulation.restore(checkpoint), Contains("another specification"));
        CHECK_THROWS_AS(simulation.run(), InputError);
    }
    Simulation mixed(small_spec(), Execution({.precision = Precision::mixed}));
    CHECK_THROWS_WITH(mixed.restore(checkpoint), Contains("another specification"));
    Simulation threads(small_spec(), Execution({.threads = 2}));
    CHECK_NOTHROW(threads.restore(checkpoint));
}

TEST_CASE("stages without a seed have that of the specification") {
    FluidSpec with_seed = small_spec();
    with_seed.stages[1].thermostat = thermostat("langevin");
    FluidSpec without = with_seed;
    without.stages[1].seed = 0;
    Simulation ours(with_seed);
    Simulation theirs(without);
    ours.run();
    theirs.run();
    check_same(ours, theirs);
    without.seed = 8;
    Simulation others(without);
    others.run();
    CHECK(checksum(others.state()) != checksum(ours.state()));
}

TEST_CASE("what an observer throws ends the simulation, which then cannot be continued") {
    struct Thrower : Observer {
        [[nodiscard]] bool needs(Index step) const override { return step == 31; }
        void sample(const Snapshot&) override { throw std::runtime_error("enough"); }
    };
    Simulation simulation(small_spec());
    Thrower thrower;
    simulation.add(thrower);
    CHECK_THROWS_WITH(simulation.run(), "enough");
    CHECK(simulation.state().step == 31);
    CHECK_THROWS_AS(simulation.run(), InputError);
    CHECK_THROWS_AS(simulation.advance(1), InputError);
    CHECK_THROWS_WITH(simulation.checkpoint(), Contains("has failed: it can be looked at"));
    CHECK_FALSE(simulation.finished());
}

TEST_CASE("an observer that throws when it is asked for its steps leaves velocities that can be looked at") {
    struct Undecided : Observer {
        [[nodiscard]] bool needs(Index step) const override {
            return step == 31 ? throw std::runtime_error("undecided") : false;
        }
        void sample(const Snapshot&) override {}
    };
    Simulation simulation(small_spec());
    Undecided undecided;
    simulation.add(undecided);
    CHECK_THROWS_WITH(simulation.run(), "undecided");
    CHECK_NOTHROW(simulation.state().velocities());  // the second half of the step's kick was pending
}

TEST_CASE("an observer sees the sampled stages only, in which it changes nothing") {
    Simulation plain(with_analyses());
    plain.run();
    Simulation watched(with_analyses());
    Watcher third(3);
    Watcher energies(4, true);
    watched.add(third);
    watched.add(energies);
    watched.run();
    CHECK(third.steps == std::vector<Index>{21, 24, 27, 30, 33, 36, 39, 42, 45, 48, 51, 54, 57, 60});
    CHECK(energies.steps.size() == 10);
    CHECK(third.interruptions == 2);  // two stages began
    check_same(watched, plain);
}

TEST_CASE("a specification with mistakes is refused with all of them") {
    FluidSpec spec = small_spec();
    spec.temperature.reset();
    spec.stages[0].time_step = -1.0;
    CHECK_THROWS_WITH(Simulation(spec), Contains("a temperature is needed") && Contains("the time step is -1"));
    CHECK_THROWS_AS(Simulation(spec), InputError);
}

TEST_CASE("results and tables are asked for by name") {
    const RunResult result = Simulation(with_analyses()).run();
    CHECK(result.observable("pressure").estimate);
    CHECK_THROWS_WITH(result.observable("presure"), Contains("no observable 'presure'") && Contains("pressure"));
    CHECK_THROWS_WITH(result.table("sk"), Contains("no table 'sk'") && Contains("rdf"));
}

TEST_CASE("a run that blows up says in which step and stage, and can be looked at") {
    for (const Index after : {0, 1, 2, 3}) {  // it blows up in another step, with a kick pending or without
        FluidSpec spec = small_spec();
        spec.stages[1].time_step = 0.5 + 0.1 * static_cast<double>(after);
        spec.stages[1].integrator = integrator(after % 2 == 0 ? "velocity-verlet" : "leapfrog");
        Simulation simulation(spec);
        simulation.advance(20 + after % 2);
        CHECK_THROWS_WITH(simulation.run(), Contains("step ") && Contains("(stage 'production')"));
        CHECK_NOTHROW(simulation.state().velocities());
        CHECK_NOTHROW(simulation.result());
        CHECK_FALSE(simulation.samples().empty());
    }
}

TEST_CASE("the start is evaluated by the first call, if only of 0 steps") {
    Simulation simulation(small_spec());
    CHECK(simulation.samples().empty());
    simulation.advance(0);
    REQUIRE(simulation.samples().size() == 1);
    CHECK(simulation.samples().front().step == 0);
    CHECK(simulation.result().first.pressure == simulation.samples().front().values.pressure);
}

TEST_CASE("a simulation that was moved to another one is an error to use, and can be assigned to") {
    Simulation first(small_spec());
    Simulation second(std::move(first));
    // NOLINTBEGIN(bugprone-use-after-move): what it does is promised
    CHECK_THROWS_WITH(first.run(), "this simulation has been moved to another one");
    CHECK_THROWS_AS(first.state(), InputError);
    CHECK_THROWS_AS(first.samples(), InputError);
    CHECK_THROWS_AS(first.checkpoint(), InputError);
    CHECK_THROWS_AS(first.restore(second.checkpoint()), InputError);
    Watcher watcher(1);
    CHECK_THROWS_AS(first.add(watcher), InputError);
    // NOLINTEND(bugprone-use-after-move)
    second.run();
    first = std::move(second);
    CHECK(first.finished());
}

TEST_CASE("an observer measures once") {
    Simulation simulation(small_spec());
    Watcher watcher(3);
    simulation.add(watcher);
    CHECK_THROWS_AS(simulation.add(watcher), InputError);
    CHECK_THROWS_WITH(simulation.add(watcher), Contains("measures already"));
    simulation.run();
    CHECK(watcher.steps.size() == 14);
}

TEST_CASE("a checkpoint needs the observers that it was written with") {
    Simulation first(small_spec());
    Watcher watcher(3);
    first.add(watcher);
    first.advance(30);
    Simulation second(small_spec());
    CHECK_THROWS_AS(second.restore(first.checkpoint()), CheckpointError);
    CHECK_THROWS_WITH(Simulation(small_spec()).restore(first.checkpoint()), Contains("1 observers of the program"));
}

TEST_CASE("energy and pressure of a simulation are known at every step, and asking for them changes no bit") {
    FluidSpec every = small_spec();
    every.sample_every = 1;
    Simulation sampled(every);
    sampled.advance(7);
    Simulation asked(small_spec());
    asked.advance(7);
    REQUIRE(asked.samples().back().step == 0);
    const Thermodynamics there = asked.thermodynamics();
    CHECK(there.potential_energy == Approx(sampled.samples().back().values.potential_energy).epsilon(1e-12));
    CHECK(there.pressure.value() == Approx(sampled.samples().back().values.pressure.value()).epsilon(1e-10));
    CHECK(sampled.thermodynamics().potential_energy == sampled.samples().back().values.potential_energy);
    asked.advance(13);
    CHECK(asked.thermodynamics().potential_energy == asked.samples().back().values.potential_energy);
    Simulation undisturbed(small_spec());
    undisturbed.advance(20);
    check_same(asked, undisturbed);
}
