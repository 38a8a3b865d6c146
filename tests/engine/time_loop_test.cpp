#include "ljmd/detail/engine/time_loop.hpp"

#include <cmath>
#include <map>
#include <set>

#include "deck/deck_fixtures.hpp"
#include "deck/fluid.hpp"
#include "engine/few_body_system.hpp"
#include "integrators/oscillator.hpp"
#include "ljmd/core/errors.hpp"
#include "model/velocities.hpp"

using namespace ljmd;
using namespace ljmd::test;

namespace {

/// Writes down, in one line each, what the time loop tells it of.
struct Log : StepObserver, MomentObserver {
    explicit Log(const State& watched, Index every = 1) : state(watched), energy_every(every) {}

    void started(const Evaluation& evaluation) override {
        events.push_back("started");
        energies[state.step] = evaluation.potential_energy;
    }
    void stage_begins(const Stage& stage) override { events.push_back("begin " + stage.name); }
    [[nodiscard]] bool wants_energy(Index step) const override { return step % energy_every == 0; }
    void moved(Index step_of_stage) override {
        events.push_back("moved " + std::to_string(step_of_stage));
        kinetic_when_moved[state.step] = kinetic_energy(state);
    }
    void step_done(const Stage& stage, const Evaluation& evaluation) override {
        events.push_back("done " + std::to_string(state.step) + " of " + stage.name);
        energies[state.step] = evaluation.potential_energy;
        times.push_back(state.time);
        kinetic_when_done[state.step] = kinetic_energy(state);
    }
    void stage_ends(const Stage& stage) override { events.push_back("end " + stage.name); }
    [[nodiscard]] bool looks_within_steps(const Stage&) const override { return looks_within; }
    void within_step(const Stage& stage, const State& moment) override {
        CHECK(moment.time > (times.empty() ? 0.0 : times.back()));
        CHECK(moment.time > last_within);
        last_within = moment.time;
        within.insert(stage.name);
    }

    LoopParty party() { return {*this, nullptr, this}; }

    const State& state;
    Index energy_every;
    bool looks_within = false;
    double last_within = 0.0;
    std::set<std::string> within;  ///< the stages
    std::vector<std::string> events;
    std::vector<double> times;
    std::map<Index, double> energies;
    std::map<Index, double> kinetic_when_moved;
    std::map<Index, double> kinetic_when_done;
};

std::string stage_text(const std::string& name, const std::string& steps, const std::string& more = "") {
    return "\n[[stage]]\nname = \"" + name + "\"\ntime_step = 0.01\nsteps = " + steps + "\n" + more;
}

const std::string springs_deck = R"([force]
type = "harmonic"
stiffness = 1.0

[[body]]
mass = 1.0
position = [1.0, 0.25]
velocity = [0.5, -1.0]
)";

/// A few-body deck with these stages, run on two swinging bodies.
struct Swing {
    explicit Swing(const std::string& stages, Index energy_every = 1)
        : deck(DeckFolder(springs_deck + stages).load()), state(swinging(springs)), log(state, energy_every) {
        run_stages(deck.stages(), state, springs, log.party());
    }

    Deck deck;
    Oscillator springs{2.0};
    State state;
    Log log;
};

/// Springs that break at one evaluation.
class Breaking : public ForceField {
  public:
    explicit Breaking(int last) : left_(last) {}

  private:
    Evaluation compute(State& state, Request) override {
        if (left_-- == 0) {
            throw PhysicsError("a spring broke");
        }
        state.write_forces().setZero();
        return {};
    }

    int left_;
};

std::string failure_after(int evaluations) {
    const Deck deck = DeckFolder(springs_deck + stage_text("one", "2") + stage_text("two", "5")).load();
    State state(1);
    Breaking springs(evaluations);
    Log log(state);
    try {
        run_stages(deck.stages(), state, springs, log.party());
    } catch (const PhysicsError& error) {
        return error.what();
    }
    return "no failure";
}

}  // namespace

TEST_CASE("the time loop tells of start, stages and steps in their order") {
    const Swing swing(stage_text("one", "2") + stage_text("none", "0") + stage_text("two", "1"));
    CHECK(swing.log.events == std::vector<std::string>{"started", "begin one", "moved 1", "done 1 of one", "moved 2",
                                                       "done 2 of one", "end one", "begin none", "end none",
                                                       "begin two", "moved 1", "done 3 of two", "end two"});
    CHECK(swing.state.step == 3);
}

TEST_CASE("time is the start of the stage and so many of its steps, not a sum of steps") {
    const Swing swing(stage_text("one", "10") + changed(stage_text("two", "3"), {{"0.01", "0.1"}}));
    REQUIRE(swing.log.times.size() == 13);
    for (std::size_t n = 0; n < 10; ++n) {
        CHECK(swing.log.times[n] == static_cast<double>(n + 1) * 0.01);
    }
    for (std::size_t n = 0; n < 3; ++n) {
        CHECK(swing.log.times[10 + n] == swing.log.times[9] + static_cast<double>(n + 1) * 0.1);
    }
}

TEST_CASE(
    "what an adaptive method goes through is told if it is wanted, between the beginning and the end of its step") {
    const std::string adaptive = "integrator = \"prince-dormand\"\n";
    const Deck deck = DeckFolder(springs_deck + stage_text("one", "7", adaptive) + stage_text("two", "5") +
                                 stage_text("three", "2", adaptive))
                          .load();
    for (const bool wanted : {false, true}) {
        Oscillator springs{2.0};
        State state = swinging(springs);
        Log log(state);
        log.looks_within = wanted;
        run_stages(deck.stages(), state, springs, log.party());
        CHECK(log.within == (wanted ? std::set<std::string>{"one", "three"} : std::set<std::string>{}));
        CHECK((!wanted || log.last_within < log.times.back()));
        CHECK(log.times.size() == 14);
    }
}

TEST_CASE("the energy is there at the start and at the steps where it is wanted") {
    const Swing swing(stage_text("one", "4") + stage_text("two", "3"), 3);
    for (const auto& [step, energy] : swing.log.energies) {
        INFO(step);
        CHECK((energy != 0.0) == (step % 3 == 0));
    }
    CHECK(swing.log.energies.size() == 8);
}

TEST_CASE("a stage cut in two is the same motion, to the last bit, for few bodies and for a fluid") {
    for (const char* integrator :
         {"velocity-verlet", "leapfrog", "leapfrog-2tau", "position-verlet", "bit-reversible"}) {
        INFO(integrator);
        const std::string choice = std::string("integrator = \"") + integrator + "\"\n";
        const Swing whole(stage_text("whole", "20", choice));
        const Swing parts(stage_text("one", "7", choice) + stage_text("none", "0", choice) +
                          stage_text("two", "13", choice));
        CHECK(positions(whole.state) == positions(parts.state));
        CHECK(velocities(whole.state) == velocities(parts.state));
    }
    const std::string parts = changed(small_deck, {{"steps = 40\nsample = true\n", "steps = 13\n"}}) +
                              "\n[[stage]]\nname = \"rest\"\ntime_step = 0.004\nsteps = 27\n";
    std::vector<FluidSystem> runs;
    for (const std::string& text : {small_deck, parts}) {
        const Deck deck = DeckFolder(text).load();
        runs.push_back(simulation_of(deck));
        Log log(runs.back().state);
        run_stages(deck.stages(), runs.back().state, runs.back().force_field, log.party());
    }
    CHECK(positions(runs[0].state) == positions(runs[1].state));
    CHECK(velocities(runs[0].state) == velocities(runs[1].state));
}

TEST_CASE("a stage that runs backwards returns to the start, while time grows") {
    for (const char* integrator : {"velocity-verlet", "leapfrog", "position-verlet", "forest-ruth", "bit-reversible"}) {
        INFO(integrator);
        const std::string choice = std::string("integrator = \"") + integrator + "\"\n";
        Oscillator springs(2.0);
        const State start = swinging(springs);
        const Swing there(stage_text("there", "50", choice));
        CHECK((positions(there.state) - positions(start)).norm() > 0.1);
        const Swing back(stage_text("there", "50", choice) + stage_text("back", "50", choice + "reverse = true\n"));
        CHECK((positions(back.state) - positions(start)).norm() < 1e-11);
        CHECK((velocities(back.state) + velocities(start)).norm() < 1e-10);
        CHECK(back.state.time == Approx(1.0));
        CHECK(back.state.step == 100);
    }
    const Swing euler(stage_text("there", "50", "integrator = \"euler\"\n") +
                      stage_text("back", "50", "integrator = \"euler\"\nreverse = true\n"));
    Oscillator springs(2.0);
    CHECK((positions(euler.state) - positions(swinging(springs))).norm() > 1e-3);
}

TEST_CASE("a failure names step and stage") {
    CHECK(failure_after(0) == "step 0: a spring broke");
    CHECK(failure_after(1) == "step 1 (stage 'one'): a spring broke");
    CHECK(failure_after(3) == "step 3 (stage 'two'): a spring broke");
    CHECK(failure_after(7) == "step 7 (stage 'two'): a spring broke");
    CHECK(failure_after(8) == "no failure");
}

TEST_CASE("a thermostat acts after the particles have moved, and only in its stage") {
    const Deck deck = DeckFolder(small_deck +
                                 "\n[[stage]]\nname = \"again\"\ntime_step = 0.004\nsteps = 10\n"
                                 "temperature = 1.3\nthermostat = { type = \"rescale\", every = 4 }\n")
                          .load({"stage.equilibrate.temperature=1.3", "stage.production.steps=41"});
    FluidSystem simulation = simulation_of(deck);
    Log log(simulation.state);
    run_stages(deck.stages(), simulation.state, simulation.force_field, log.party());
    const double wanted = 1.3 * 1.5 * (108.0 - 1.0);  // 3 (N - 1) degrees of freedom
    REQUIRE(log.kinetic_when_done.size() == 71);
    for (const auto& [step, kinetic] : log.kinetic_when_done) {
        INFO(step);
        const bool acts = (step <= 20 && step % 5 == 0) || step == 61 + 4 || step == 61 + 8;
        CHECK((kinetic != log.kinetic_when_moved.at(step)) == acts);
        if (acts) {
            CHECK(kinetic == Approx(wanted).epsilon(1e-12));
        }
    }
}

TEST_CASE("after a thermostat that moves the centre of mass, it is brought to rest where momentum is conserved again") {
    const auto momenta = [](const std::string& first, const std::string& second) {
        const std::string stage = "\n[[stage]]\nname = \"";
        const std::string steps = "\"\ntime_step = 0.004\nsteps = 5\n";
        const auto bath = [](const std::string& type) {
            return type.empty() ? "" : "thermostat = { type = \"" + type + "\", time = 0.01 }\n";
        };
        const std::string text = small_deck.substr(0, small_deck.find("\n[[stage]]")) + stage + "one" + steps +
                                 bath(first) + stage + "two" + steps + bath(second);
        const Deck deck = DeckFolder(text).load();
        FluidSystem simulation = simulation_of(deck);
        Log log(simulation.state);
        std::vector<double> found;
        run_stages({deck.stages()[0]}, simulation.state, simulation.force_field, log.party());
        found.push_back(total_momentum(simulation.state).norm());
        FluidSystem again = simulation_of(deck);
        Log other(again.state);
        run_stages(deck.stages(), again.state, again.force_field, other.party());
        found.push_back(total_momentum(again.state).norm());
        return found;
    };
    for (const std::string moving : {"langevin", "andersen"}) {
        CAPTURE(moving);
        for (const std::string conserving : {"", "stochastic-rescaling"}) {
            const auto p = momenta(moving, conserving);
            CHECK(p[0] > 0.1);
            CHECK(p[1] < 1e-11);
        }
        CHECK(momenta(moving, "langevin")[1] > 0.1);
    }
    CHECK(momenta("nose-hoover-chain", "")[0] < 1e-11);
}

TEST_CASE("a barostat changes the box when its steps come, between two steps, and the pressure follows") {
    const std::string text = changed(small_deck, {{"thermostat = { type = \"rescale\", every = 5 }",
                                                   "thermostat = { type = \"stochastic-rescaling\" }\n"
                                                   "barostat = { type = \"stochastic-cell-rescaling\", "
                                                   "pressure = 1.0, every = 5 }"}});
    const Deck deck = DeckFolder(text).load();
    FluidSystem simulation = simulation_of(deck);
    struct Edges : Log {
        using Log::Log;
        void step_done(const Stage& stage, const Evaluation& evaluation) override {
            Log::step_done(stage, evaluation);
            edges.push_back(state.box().edges()[0]);
            CHECK(state.forces_are_current());
        }
        std::vector<double> edges;
    };
    Edges log(simulation.state, 1000);
    run_stages(deck.stages(), simulation.state, simulation.force_field, log.party(), std::nullopt,
               fluid_spec(deck).interaction());
    REQUIRE(log.edges.size() == 60);
    for (std::size_t step = 2; step <= 60; ++step) {
        INFO(step);
        const bool changed_before = (step - 1) % 5 == 0 && step <= 21;
        CHECK((log.edges[step - 1] != log.edges[step - 2]) == changed_before);
    }
    CHECK(log.energies.at(5) != 0.0);  // needed for the pressure, though nobody else asked
    CHECK(log.energies.at(6) == 0.0);
}

TEST_CASE("a run is not resumed when the state lacks the variables of the thermostat") {
    const Deck deck =
        DeckFolder(changed(small_deck, {{"type = \"rescale\", every = 5", "type = \"nose-hoover-chain\""}})).load();
    FluidSystem simulation = simulation_of(deck);
    Log log(simulation.state);
    simulation.state.bath = {0.0, 1.0};
    LoopPosition position;
    position.begun = true;
    CHECK_THROWS_AS(run_stages(deck.stages(), simulation.state, simulation.force_field, log.party(), position),
                    CheckpointError);
}
