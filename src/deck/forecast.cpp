#include "ljmd/deck/forecast.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <utility>

#include "ljmd/core/errors.hpp"
#include "ljmd/deck/size_forecast.hpp"
#include "ljmd/integrators/integrator.hpp"
#include "ljmd/model/lattice.hpp"
#include "ljmd/model/velocities.hpp"

namespace ljmd {

namespace {

constexpr double trial_seconds = 0.3;
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

/// Measured seconds per atom for all stages, from a trial of each integrator on a stand-in for the start.
double seconds_per_atom(const Deck& deck, const Start& start, const Execution& execution) {
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
    const double temperature = deck.system().temperature.value_or(1.0);
    draw_velocities(state, std::min(temperature, hottest_trial), 1);
    PairForceField force_field = make_force_field(fluid_spec(deck), execution);
    std::map<std::string, double> seconds;  // per step, by integrator
    double sum = 0.0;
    Index evaluations_of_start = 1;  // takes about as long as a step
    for (const Stage& stage : deck.stages) {
        const auto [trial, is_new] = seconds.try_emplace(stage.integrator.plugin.name);
        if (is_new) {
            State copy = state;
            trial->second = seconds_per_step(stage.integrator.plugin.name, copy, force_field);
        }
        sum += static_cast<double>(stage.steps + std::exchange(evaluations_of_start, 0)) * trial->second;
    }
    return sum / static_cast<double>(atoms);
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
    return {memory, disk, static_cast<double>(start.atoms) * seconds_per_atom(deck, start, execution),
            execution.threads()};
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
    for (const Stage& stage : deck.stages) {
        text += fmt::format("  stage     '{}': {}{} steps of {:.6g} tau = {:.6g} tau{}\n", stage.name,
                            stage.until.empty() ? "" : "at most ", stage.steps, stage.time_step,
                            static_cast<double>(stage.steps) * stage.time_step, stage.sample ? ", sampled" : "");
        at_most = stage.until.empty() ? at_most : "at most ";
    }
    text += fmt::format("  memory    about {}\n", bytes(forecast.memory_bytes));
    text += fmt::format("  disk      {}about {} in {}\n", at_most, bytes(forecast.disk_bytes), deck.directory.string());
    text += fmt::format("  time      {}about {} on this machine with {}, analyses not counted\n", at_most,
                        duration(forecast.seconds), in_words(forecast.threads));
    return {{{"deck", deck.path},
             {"atoms", start.atoms},
             {"box_edges", Data::list({edges[0], edges[1], edges[2]})},
             {"cutoff", cutoff},
             {"largest_cutoff", 0.5 * start.box.shortest_edge()},
             {"steps", total_steps(deck.stages)},
             {"steps_are_most", !at_most.empty()},
             {"memory_bytes", forecast.memory_bytes},
             {"disk_bytes", forecast.disk_bytes},
             {"seconds", forecast.seconds}},
            text};
}

}  // namespace ljmd
