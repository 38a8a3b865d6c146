#include "compare/crosscheck.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <future>

#include "compare/lammps.hpp"
#include "compare/openmm.hpp"
#include "compare/point_comparison.hpp"
#include "core/stopwatch.hpp"
#include "execution/thread_team.hpp"
#include "execution/threads.hpp"
#include "integrators/integrator.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/engine/time_loop.hpp"

namespace ljmd {

namespace {

/// Trajectory rows besides those compared: enough for a curve.
constexpr Index rows_of_curve = 100;
/// The coordinates of all rows, of both programs, stay below half a gigabyte.
constexpr Index max_places = 10'000'000;

constexpr Index default_bins = 250;
constexpr Index default_frames = 300;
/// Sampling is costly in other programs, and closely spaced samples are strongly correlated.
constexpr Index max_samples = 2500;

constexpr int rounds = 3;
constexpr double seconds_per_round = 0.5;
constexpr Index steps_to_calibrate = 20;

/// Reports only steps.
class Quiet : public StepObserver {
  public:
    Quiet(State& state, RunListener& listener) : state_(state), listener_(listener) {}
    void stage_begins(const Stage& stage) override { listener_.stage_begins(stage); }
    [[nodiscard]] bool wants_energy(Index) const override { return false; }
    [[nodiscard]] bool reads_velocities(Index) const override { return false; }
    void step_done(const Stage&, const Evaluation&) override { listener_.step_done(state_.step); }

  private:
    State& state_;
    RunListener& listener_;
};

/// Check that the system grants this many additional threads: OpenMM hangs if a thread is refused.
/// @throws ThreadsError
void require_threads(int count) {
    try {
        const ThreadTeam as_many(count + 1);  // plus this thread
    } catch (const ThreadsError& refused) {
        throw ThreadsError(fmt::format("OpenMM takes threads of its own, {}: {}", count, refused.what()));
    }
}

Peers peers_of(const Fluid& fluid, const Situation& situation, bool mixed, int threads,
               const CrosscheckOptions& options) {
    if (options.with == "lammps") {
        return {make_lammps_peer(fluid, threads), nullptr,
                mixed ? single_agreement(situation) : lammps_agreement(situation)};
    }
    const bool exact = options.platform == "Reference";
    const bool fast = exact && (options.wants("averages") || options.wants("speed"));
    if (fast || options.platform == "CPU") {
        require_threads(threads);
    }
    Peers peers{make_openmm_peer(fluid, {.platform = options.platform, .threads = threads}), nullptr,
                exact && !mixed ? double_agreement(situation) : single_agreement(situation)};
    if (fast) {
        peers.fast = make_openmm_peer(fluid, {.platform = "CPU", .threads = threads});
    }
    return peers;
}

/// Steps of the trajectory rows: those to compare, and evenly spaced ones for the curve.
std::vector<Index> steps_of_trajectory(const CrosscheckOptions& options, Index atoms) {
    std::vector<Index> steps{0, options.steps};
    for (const Index frame : options.frames) {
        if (frame <= options.steps) {
            steps.push_back(frame);
        }
    }
    const Index stride = std::max<Index>(1, options.steps / rows_of_curve);
    if (atoms * rows_of_curve <= max_places) {
        for (Index step = stride; step < options.steps; step += stride) {
            steps.push_back(step);
        }
    }
    std::sort(steps.begin(), steps.end());
    steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
    return steps;
}

EnsembleOptions ensemble_options(const Deck& deck, const Stage& stage, const State& state) {
    const std::string& name = stage.integrator.name;
    const bool paired = name == "leapfrog" || name == "velocity-verlet";
    EnsembleOptions options{.integrator = paired ? name : "velocity-verlet",
                            .time_step = stage.time_step,
                            .steps = stage.steps,
                            .every = deck.sample_every(),
                            .frame_every = 0,
                            .bins = default_bins,
                            .radius = 0.5 * state.box().shortest_edge(),
                            .execution = state.execution()};
    options.every *= std::max<Index>(1, options.steps / options.every / max_samples);
    options.frame_every = options.every * std::max<Index>(1, options.steps / options.every / default_frames);
    return options;
}

/// Wall time of this many steps of ljmd [s].
double our_seconds(const Fluid& fluid, ForceField& force_field, const EnsembleOptions& options, Index steps) {
    State state = state_of(fluid, options.execution);
    const Integrator method(find_integrator(options.integrator), options.time_step);
    for (Index n = 0; n < steps_to_calibrate; ++n) {
        method.step(state, force_field, Request::forces);
    }
    Stopwatch watch;
    for (Index n = 0; n < steps; ++n) {
        method.step(state, force_field, Request::forces);
    }
    return watch.lap();
}

Index steps_for_a_round(double seconds_of_calibration) {
    const double step = std::max(seconds_of_calibration, 1e-9) / static_cast<double>(steps_to_calibrate);
    return std::max<Index>(steps_to_calibrate, std::llround(seconds_per_round / step));
}

SpeedComparison compare_speeds(const Fluid& fluid, const MakeForceField& make_force_field, Peer& peer,
                               const EnsembleOptions& options) {
    const auto ours = [&](Index steps) { return our_seconds(fluid, *make_force_field(), options, steps); };
    const auto theirs = [&](Index steps) { return peer.seconds(options.time_step, steps); };
    const Index our_steps = steps_for_a_round(ours(steps_to_calibrate));
    const Index their_steps = steps_for_a_round(theirs(steps_to_calibrate));
    std::array<double, rounds> our_rates{};
    std::array<double, rounds> their_rates{};
    const auto atoms = static_cast<double>(fluid.masses.size());
    for (std::size_t k = 0; k < rounds; ++k) {
        our_rates[k] = atoms * static_cast<double>(our_steps) / ours(our_steps);
        their_rates[k] = atoms * static_cast<double>(their_steps) / theirs(their_steps);
    }
    std::sort(our_rates.begin(), our_rates.end());
    std::sort(their_rates.begin(), their_rates.end());
    return {our_rates[rounds / 2], their_rates[rounds / 2]};
}

void append(std::vector<Check>& checks, const std::vector<Check>& more) {
    checks.insert(checks.end(), more.begin(), more.end());
}

}  // namespace

bool CrosscheckOptions::wants(const std::string& part) const {
    return parts.empty() || std::find(parts.begin(), parts.end(), part) != parts.end();
}

const std::vector<std::string>& crosscheck_parts() {
    static const std::vector<std::string> parts{"point", "trajectory", "averages", "speed"};
    return parts;
}

bool Crosscheck::passed() const {
    return failures() == 0;
}

Index Crosscheck::failures() const {
    return std::count_if(checks.begin(), checks.end(), [](const Check& check) { return !check.passed(); });
}

Index steps_before_crosscheck(const Deck& deck) {
    return steps_before(deck.stages(), first_sampled(deck.stages()));
}

Fluid run_before_crosscheck(const Deck& deck, FluidSystem& simulation, RunListener& listener) {
    const FluidSpec spec = fluid_spec(deck);
    const std::size_t compared = first_sampled(deck.stages());
    const std::vector<Stage> before(deck.stages().begin(),
                                    deck.stages().begin() + static_cast<std::ptrdiff_t>(compared));
    Quiet quiet(simulation.state, listener);
    run_stages(before, simulation.state, simulation.force_field, {quiet}, std::nullopt, spec.interaction());
    return fluid_of(simulation.state, simulation.force_field.potential(), spec.has_tail());
}

Crosscheck crosscheck(const Deck& deck, FluidSystem& simulation, const CrosscheckOptions& options,
                      RunListener& listener, const std::function<void(const std::string&)>& say) {
    const FluidSpec spec = fluid_spec(deck);
    const std::size_t compared = first_sampled(deck.stages());
    const Stage& stage = deck.stages()[compared];
    if (stage.total_energy) {
        say(fmt::format("stage '{}' is compared at the energy of its start: velocities are not scaled to total_energy",
                        stage.name));
    }
    if (stage.thermostat) {
        say(fmt::format("stage '{}' is compared at constant energy: its {} out", stage.name,
                        stage.barostat ? "thermostat and its barostat are left" : "thermostat is left"));
    }
    const auto fluid_now = [&] {
        return fluid_of(simulation.state, simulation.force_field.potential(), spec.has_tail());
    };
    const Execution& execution = simulation.state.execution();
    const bool mixed = simulation.force_field.precision() == Precision::mixed;
    // Report a missing program now, not after minutes of equilibration.
    static_cast<void>(peers_of(fluid_now(), {}, mixed, execution.threads(), options));

    const Fluid fluid = run_before_crosscheck(deck, simulation, listener);
    const Peers peers = peers_of(fluid, situation_of(fluid, stage.time_step), mixed, execution.threads(), options);
    const MakeForceField make = [&] { return std::make_unique<PairForceField>(make_force_field(spec, execution)); };
    const EnsembleOptions ensemble = ensemble_options(deck, stage, simulation.state);
    const bool kernel = deck.neighbors().keeps_list();
    Crosscheck result{.peer = peers.exact->name(),
                      .fast_peer = peers.for_long_runs().name(),
                      .atoms = simulation.state.count(),
                      .steps_before = simulation.state.step,
                      .search = deck.neighbors().method,
                      .simd = kernel ? std::string(name(simulation.force_field.simd())) : "scalar",
                      .precision = std::string(name(simulation.force_field.precision())),
                      .threads = execution.threads(),
                      .integrator = ensemble.integrator,
                      .steps_of_averages = ensemble.steps,
                      .checks = {},
                      .trajectory = {},
                      .ensemble = std::nullopt,
                      .speed = std::nullopt};
    // The other program's long run is concurrent if there is a free processor and the system grants a thread; else it
    // is later.
    const bool averages = options.wants("averages") && ensemble.steps >= ensemble.every;
    std::future<EnsembleAverages> theirs;
    if (averages) {
        say(fmt::format("averaging over {} steps in {}", ensemble.steps, peers.for_long_runs().name()));
        theirs = std::async(execution.threads() < available_processors() && peers.fast
                                ? std::launch::async | std::launch::deferred
                                : std::launch::deferred,
                            [&] { return their_averages(fluid, peers.for_long_runs(), ensemble); });
    }
    if (options.wants("point")) {
        const PeerPoint ours = point_of(fluid, *make(), execution);
        append(result.checks, compare_points(ours, peers.exact->point(), fluid, peers.agreement));
    }
    if (options.wants("trajectory") && options.steps > 0) {
        say(fmt::format("following trajectories over {} steps in {}", options.steps, peers.exact->name()));
        result.trajectory = compare_trajectories(fluid, make, *peers.exact, stage.time_step,
                                                 steps_of_trajectory(options, result.atoms), execution);
        append(result.checks, checks_of(result.trajectory, options.frames, peers.agreement));
    }
    if (averages) {
        const EnsembleAverages ours = our_averages(fluid, *make(), ensemble);
        result.ensemble = compare_ensembles(ours, theirs.get());
        append(result.checks, checks_of(*result.ensemble, fluid));
    }
    if (options.wants("speed")) {
        say("measuring speeds");
        result.speed = compare_speeds(fluid, make, peers.for_long_runs(), ensemble);
    }
    return result;
}

}  // namespace ljmd
