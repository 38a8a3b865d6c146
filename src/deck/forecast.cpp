#include "deck/forecast.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "deck/size_forecast.hpp"
#include "integrators/integrator.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/model/lattice.hpp"
#include "model/velocities.hpp"

namespace ljmd {

namespace {

constexpr double trial_seconds = 0.3;       // of each integrator and analysis
constexpr double most_bytes = 1e9;          // of an analysis that is tried
constexpr Index counted_steps = 1'000'000;  // in which samples are counted
constexpr Index stand_in_atoms = 4000;
constexpr double default_time_step = 0.004;
constexpr double hottest_trial = 2.0;  // [epsilon/k_B]; stable with the usual time step

double density_of(const Start& start) {
    return static_cast<double>(start.atoms) / start.box.volume();
}

/// Measured seconds per step, pair search and integration included.
double seconds_per_step(const std::string& method, State& state, PairForceField& force_field) {
    const Integrator integrator(find_integrator(method), default_time_step);
    force_field.evaluate(state, Request::forces);
    const auto began = std::chrono::steady_clock::now();
    std::chrono::duration<double> took{};
    Index steps = 0;
    try {
        do {
            integrator.step(state, force_field, Request::forces);
            ++steps;
            took = std::chrono::steady_clock::now() - began;
        } while (took.count() < trial_seconds);
    } catch (const PhysicsError&) {
        // The usual time step is too large for this potential: use what was measured until it blew up.
    }
    return took.count() / static_cast<double>(std::max<Index>(steps, 1));
}

/// A crystal that stands in for the start, as dense and as hot.
State stand_in(const Deck& deck, const Start& start, const Execution& execution) {
    const double density = density_of(start);
    const double cutoff = deck.potential().radius;
    Index cells = nearest_cells(Lattice::fcc, std::min(start.atoms, stand_in_atoms)).above;
    while (2.0 * cutoff > cubic_box(lattice_atoms(Lattice::fcc, cells), density).shortest_edge()) {
        ++cells;
    }
    const Index atoms = lattice_atoms(Lattice::fcc, cells);
    const Box box = cubic_box(atoms, density);
    State state(atoms, box, execution);
    const auto sites = lattice_sites(Lattice::fcc, cells, box);
    auto r = state.write_positions();
    for (Index i = 0; i < atoms; ++i) {
        r.col(i) = sites[static_cast<std::size_t>(i)];
    }
    draw_velocities(state, std::min(deck.system().temperature.value_or(1.0), hottest_trial), 1);
    return state;
}

/// Measured seconds for all stages, from a trial of each integrator.
double seconds_of_stages(const Deck& deck, const State& start, PairForceField& force_field) {
    std::map<std::string, double> seconds;  // per step, by integrator
    double sum = 0.0;
    Index evaluations_of_start = 1;  // takes about as long as a step
    for (const Stage& stage : deck.stages()) {
        const auto [trial, is_new] = seconds.try_emplace(stage.integrator.name);
        if (is_new) {
            State copy = start;
            trial->second = seconds_per_step(stage.integrator.name, copy, force_field);
        }
        sum += static_cast<double>(stage.steps + std::exchange(evaluations_of_start, 0)) * trial->second;
    }
    return sum;
}

/// Configurations that an analysis samples in all stages.
double samples_of(const Analysis& analysis, const std::vector<Stage>& stages) {
    double sampled_steps = 0.0;
    for (const Stage& stage : stages) {
        sampled_steps += stage.sample ? static_cast<double>(stage.steps) : 0.0;
    }
    const auto looked_at = static_cast<Index>(std::min(sampled_steps, static_cast<double>(counted_steps)));
    Index due = 0;
    for (Index step = 1; step <= looked_at; ++step) {
        due += analysis.due(step) ? 1 : 0;
    }
    return looked_at > 0 ? sampled_steps * static_cast<double>(due) / static_cast<double>(looked_at) : 0.0;
}

/// Measured seconds of all samples of an analysis. Empty if it does not take the stand-in.
std::optional<double> seconds_of_analysis(const Choice& choice, const Deck& deck, const SampledRun& run, State state,
                                          PairForceField& force_field) {
    const ChosenAnalysis chosen = chosen_analysis(choice);
    const AnalysisSize size = chosen.options->size(run);
    if (!chosen.options->check(run).empty() || size.kept + size.fixed + size.passing > most_bytes) {
        return std::nullopt;
    }
    try {
        const auto analysis = chosen.options->make(run);
        const double samples = samples_of(*analysis, deck.stages());
        const Evaluation evaluation = force_field.evaluate(state, Request::forces_and_energy);
        const auto began = std::chrono::steady_clock::now();
        std::chrono::duration<double> took{};
        double taken = 0.0;
        while (taken < samples && took.count() < trial_seconds) {
            analysis->sample(state, evaluation);
            ++state.step;
            ++taken;
            took = std::chrono::steady_clock::now() - began;
        }
        return taken > 0.0 ? samples * took.count() / taken : 0.0;
    } catch (const PhysicsError&) {
        return std::nullopt;  // of a crystal: the fluid may have it
    }
}

std::string bytes(double n) {
    return n < 1e6   ? fmt::format("{:.0f} kB", n / 1e3)
           : n < 1e9 ? fmt::format("{:.1f} MB", n / 1e6)
                     : fmt::format("{:.1f} GB", n / 1e9);
}

std::string duration(double seconds) {
    return seconds < 120.0    ? fmt::format("{:.0f} s", std::ceil(seconds))
           : seconds < 7200.0 ? fmt::format("{:.0f} min", seconds / 60.0)
                              : fmt::format("{:.1f} h", seconds / 3600.0);
}

std::string in_words(int threads) {
    return threads == 1 ? "one thread" : fmt::format("{} threads", threads);
}

}  // namespace

Forecast forecast(const Deck& deck, const Start& start, const Execution& execution) {
    const auto [memory, disk] = forecast_size(deck, start);
    Forecast cost{memory, disk, 0.0, execution.threads()};
    const FluidSpec spec = fluid_spec(deck);
    const State state = stand_in(deck, start, execution);
    PairForceField force_field = make_force_field(spec, execution);
    double seconds = seconds_of_stages(deck, state, force_field);
    SampledRun run = sampled_run(deck, state.total(), state.box());
    run.interaction = spec.interaction();
    for (const Choice& analysis : spec.analyses) {
        const auto more = seconds_of_analysis(analysis, deck, run, state, force_field);
        seconds += more.value_or(0.0);
        if (!more) {
            cost.not_counted.push_back(analysis.name);
        }
    }
    cost.seconds = seconds * static_cast<double>(start.atoms) / static_cast<double>(state.total());
    return cost;
}

Document check_report(const Deck& deck, const Start& start, const Forecast& forecast) {
    const Vec3& edges = start.box.edges();
    const double cutoff = deck.potential().radius;
    std::string text = fmt::format("{}: the deck is good. Nothing was run.\n", deck.path);
    text += fmt::format("  atoms     {}\n", start.atoms);
    text += fmt::format("  box       {:.6g} x {:.6g} x {:.6g} sigma^3, density {:.6g} sigma^-3\n", edges[0], edges[1],
                        edges[2], density_of(start));
    text += fmt::format("  cutoff    {:.6g} sigma, at most L/2 = {:.6g}\n", cutoff, 0.5 * start.box.shortest_edge());
    std::string at_most;  // with a stage that may end earlier
    for (const Stage& stage : deck.stages()) {
        text += fmt::format("  stage     '{}': {}{} steps of {:.6g} tau = {:.6g} tau{}\n", stage.name,
                            stage.until.empty() ? "" : "at most ", stage.steps, stage.time_step,
                            static_cast<double>(stage.steps) * stage.time_step, stage.sample ? ", sampled" : "");
        at_most = stage.until.empty() ? at_most : "at most ";
    }
    text += fmt::format("  memory    about {}\n", bytes(forecast.memory_bytes));
    text += fmt::format("  disk      {}about {} in {}\n", at_most, bytes(forecast.disk_bytes), deck.directory.string());
    text += fmt::format("  time      {}about {} on this machine with {}{}{}\n", at_most, duration(forecast.seconds),
                        in_words(forecast.threads), forecast.not_counted.empty() ? "" : ", not counted ",
                        fmt::join(forecast.not_counted, ", "));
    return {{{"deck", deck.path},
             {"atoms", start.atoms},
             {"box_edges", Data::list({edges[0], edges[1], edges[2]})},
             {"cutoff", cutoff},
             {"largest_cutoff", 0.5 * start.box.shortest_edge()},
             {"steps", total_steps(deck.stages())},
             {"steps_are_most", !at_most.empty()},
             {"memory_bytes", forecast.memory_bytes},
             {"disk_bytes", forecast.disk_bytes},
             {"seconds", forecast.seconds},
             {"analyses_not_counted", forecast.not_counted}},
            text};
}

}  // namespace ljmd
