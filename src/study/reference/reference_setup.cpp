#include "study/reference/reference_setup.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "ljmd/core/errors.hpp"
#include "ljmd/detail/potentials/tail_correction.hpp"
#include "ljmd/engine/choices.hpp"
#include "ljmd/engine/fluid_spec.hpp"
#include "ljmd/reference/pressure_states.hpp"
#include "ljmd/run/spec_deck.hpp"

namespace ljmd {

namespace {

constexpr double shortest_cutoff = 2.5;
constexpr double switching_width = 0.5;
constexpr double least_energy = 3.0;  // of all atoms: so many pairs are near each other
constexpr double counted_beyond_cutoff = 2.0;
constexpr Index steps_of_melt = 1500;
constexpr double usual_time_step = 0.005;
constexpr double temperature_of_time_step = 2.0;  // above it the step shrinks as 1/sqrt(T)

/// Cells of the lattice and cutoff for S(0) up to a limit. Where the density fluctuates the structure responds to what
/// the cutoff leaves out, and first order is not enough for a short one: the response is a part of some 2 |c| rho
/// S(0)/T.
struct SizeChoice {
    double structure_factor;
    Index cells;
    double cutoff;
};
constexpr std::array<SizeChoice, 4> size_choices{
    {{1.5, 6, 4.0}, {3.0, 7, 5.0}, {6.0, 9, 6.0}, {max_structure_factor_at_zero, 10, 7.0}}};

double time_step_at(double temperature) {
    return usual_time_step * std::min(1.0, std::sqrt(temperature_of_time_step / temperature));
}

/// c of p_tail = c rho^2.
double tail_coefficient(const PairPotential& potential) {
    return TailCorrection(potential).pressure(1.0);
}

double checked_number(const std::string& name, double value) {
    if (!(value > 0.0) || !std::isfinite(value)) {
        throw InputError(fmt::format("{} {} is not allowed: a finite number > 0", name, value));
    }
    return value;
}

double density_of(const ReferenceRequest& request, const EquationOfState& equation) {
    if (request.density.has_value() == request.pressure.has_value()) {
        throw InputError("a state has a density or a pressure: give one of them");
    }
    if (request.density) {
        return checked_number("density", *request.density);
    }
    const auto states =
        states_at_pressure(equation, request.temperature, checked_number("pressure", *request.pressure));
    return states.front().state.density;
}

/// Why a state is refused; empty if it is not.
std::string refusal(const PhaseOfState& phase, bool metastable) {
    const std::string lines = phase.lines();
    switch (phase.phase) {
        case FluidPhase::two_phases:
            return fmt::format(
                "the fluid separates into vapour and liquid there ({}): give the density of one of them, or `ljmd eos` "
                "has both",
                lines);
        case FluidPhase::solid:
            return fmt::format(
                "the crystal is the stable phase there ({}), and values of crystals are not vouched for: their cutoff "
                "is not corrected, and they have no vacancies",
                lines);
        case FluidPhase::metastable_gas:
        case FluidPhase::metastable_liquid:
        case FluidPhase::supercooled_liquid:
            return metastable ? ""
                              : fmt::format("the state is a {} ({}): --metastable accepts it, as long as it lasts",
                                            name_of(phase.phase), lines);
        default:
            return "";
    }
}

Index cells_of(Index atoms) {
    const auto cells = static_cast<Index>(std::lround(std::cbrt(static_cast<double>(atoms) / 4.0)));
    if (cells < 3 || 4 * cells * cells * cells != atoms) {
        throw InputError(
            fmt::format("{} atoms do not fill an fcc lattice of cubic cells: 108, 256, 500, 864, ...", atoms));
    }
    return cells;
}

PairPotential switched(double longest, double edge) {
    const double cutoff = std::min(longest, std::floor(50.0 * edge) / 100.0);
    if (cutoff < shortest_cutoff) {
        throw InputError(fmt::format(
            "half the box is {:.4g} sigma, and the shortest cutoff is {}: take more atoms, {} times as many at least",
            0.5 * edge, shortest_cutoff, std::ceil(10.0 * std::pow(2.0 * shortest_cutoff / edge, 3)) / 10.0));
    }
    return PairPotential::lennard_jones("switched", {cutoff, cutoff - switching_width});
}

const SizeChoice& size_for(const EquationOfState& equation, double temperature, double density) {
    const double s0 = structure_factor_at_zero(equation, temperature, density, 0.0);
    const auto* const found =
        std::ranges::find_if(size_choices, [&](const SizeChoice& choice) { return s0 <= choice.structure_factor; });
    if (found == size_choices.end()) {
        throw PhysicsError(
            fmt::format("the state is too near the critical point: S(0) = {:.3g}, and boxes of a few thousand atoms "
                        "are large enough up to {}",
                        s0, max_structure_factor_at_zero));
    }
    return *found;
}

void check_errors(const ReferenceRequest& request) {
    for (const WantedError& wanted : request.errors) {
        checked_number(fmt::format("the error of {}", wanted.observable), wanted.error);
        const auto& measured = reference_property(wanted.observable).measured;
        if (measured == MeasuredBy::structure) {
            throw InputError(fmt::format("{} is a table: it has no single error to wait for", wanted.observable));
        }
        if (std::ranges::find(request.properties, wanted.observable) == request.properties.end()) {
            throw InputError(
                fmt::format("an error of {} is wanted, but it is not among the properties", wanted.observable));
        }
        if (std::ranges::count(request.errors, wanted.observable, &WantedError::observable) > 1) {
            throw InputError(fmt::format("the error of {} is given twice", wanted.observable));
        }
    }
    if (request.replicas < 2) {
        throw InputError(fmt::format("{} replicas are not allowed: 2 or more", request.replicas));
    }
}

/// Errors that are always waited for, where none is asked for.
void add_default_errors(ReferenceRequest& request, const FluidProperties& expected) {
    if (!request.errors.empty()) {
        return;
    }
    // In a gas the energy comes from few pairs at a time, and its relative error falls slowly.
    const double energy = std::max(1e-3 * std::abs(expected.potential_energy), 5e-4 * expected.temperature);
    request.errors = {{"potential_energy", energy}, {"pressure", 1e-2 * expected.density * expected.temperature}};
}

/// Relaxation times of a thin gas by the first approximation of Chapman and Enskog [tau]: D/T of velocities, eta/(rho
/// T) of stress; below a liquid's at liquid densities.
double relaxation_time(const ReferenceSetup& setup) {
    const double t = setup.request.temperature;
    // Neufeld, Janzen and Aziz (1972), doi:10.1063/1.1678363: the collision integral of viscosity
    const double omega =
        1.16145 * std::pow(t, -0.14874) + 0.52487 * std::exp(-0.77320 * t) + 2.16178 * std::exp(-2.43787 * t);
    const double viscosity = 5.0 / 16.0 * std::sqrt(t / std::numbers::pi) / omega;
    return 1.2 * viscosity / (setup.density * t);
}

Stage stage_of(const char* name, double time_step, Index steps) {
    return {.name = name, .time_step = time_step, .steps = steps};
}

/// A run that melts, equilibrates, and ends with a stage that is sampled.
FluidSpec spec_of(const ReferenceSetup& setup, Index equilibration, Stage sampled, std::vector<Choice> analyses = {}) {
    const ReferenceRequest& request = setup.request;
    Stage melt = stage_of("melt", time_step_at(setup.temperature_of_melt), steps_of_melt);
    melt.temperature = setup.temperature_of_melt;
    melt.thermostat = thermostat("langevin", {{"time", 0.2}});
    Stage equilibrate = stage_of("equilibrate", setup.time_step, equilibration);
    equilibrate.thermostat = thermostat("langevin");
    sampled.sample = true;
    return {.start = LatticeStart{.cells = setup.cells},
            .density = setup.density,
            .temperature = request.temperature,
            .seed = request.seed,
            .potential = setup.potential,
            .tail = true,
            .stages = {std::move(melt), std::move(equilibrate), std::move(sampled)},
            .sample_every = rows_every,
            .analyses = std::move(analyses)};
}

std::string state_words(const ReferenceSetup& setup) {
    return fmt::format("T = {}, rho = {}", setup.request.temperature, setup.density);
}

Index rounded_up(double steps) {
    constexpr double multiple = 1000.0;
    return static_cast<Index>(std::ceil(steps / multiple) * multiple);
}

/// Largest time of correlations, at most a twentieth of the longest runs that are allowed.
double longest_lag(const ReferenceSetup& setup) {
    const double run = static_cast<double>(setup.request.max_steps) * transport_time_step(setup);
    return std::min(std::max(5.0, 8.0 * relaxation_time(setup)), 0.05 * run);
}

}  // namespace

bool ReferenceRequest::needs(MeasuredBy measured) const {
    return std::ranges::any_of(properties,
                               [&](const std::string& name) { return reference_property(name).measured == measured; });
}

double ReferenceSetup::edge() const {
    return std::cbrt(static_cast<double>(atoms) / density);
}

double ReferenceSetup::counted_radius() const {
    return std::min(potential.cutoff().radius + counted_beyond_cutoff, std::floor(500.0 * edge()) / 1000.0);
}

ReferenceSetup reference_setup(const ReferenceRequest& asked) {
    checked_number("temperature", asked.temperature);
    check_errors(asked);
    const EquationOfState thol = equation_of_state("thol2016");
    const EquationOfState other = equation_of_state("kolafa-nezbeda1994");
    const double t = asked.temperature;
    const double density = density_of(asked, thol);
    const FluidProperties expected = properties(thol, t, density);
    if (const std::string outside = outside_of_range(thol, expected); !outside.empty()) {
        throw PhysicsError(fmt::format("{}: what is not measured there cannot be corrected", outside));
    }
    const PhaseOfState phase = phase_of_state(thol, t, density);
    if (const std::string why = refusal(phase, asked.metastable); !why.empty()) {
        throw PhysicsError(why);
    }
    const SizeChoice& size = size_for(thol, t, density);
    const Index cells = asked.atoms > 0 ? cells_of(asked.atoms) : size.cells;
    const Index atoms = 4 * cells * cells * cells;
    if (static_cast<double>(atoms) * std::abs(expected.potential_energy) < least_energy) {
        throw PhysicsError(fmt::format(
            "the gas is so thin that {} atoms hardly meet: the energy of all is {:.2g}; what runs would measure is "
            "known "
            "better from the second virial coefficient, Z = 1 + {:.6g} rho",
            atoms, static_cast<double>(atoms) * expected.potential_energy, second_virial_coefficient(thol, t)));
    }
    PairPotential potential = switched(size.cutoff, std::cbrt(static_cast<double>(atoms) / density));
    const double tail = tail_coefficient(potential);
    ReferenceSetup setup{.request = asked,
                         .density = density,
                         .phase = phase,
                         .expected = expected,
                         .cells = cells,
                         .atoms = atoms,
                         .potential = std::move(potential),
                         .time_step = time_step_at(t),
                         .temperature_of_melt = std::max(3.0, 1.5 * t),
                         .size = canonical_size_shift(thol, t, density, atoms, tail),
                         .size_by_other = canonical_size_shift(other, t, density, atoms, tail),
                         .remarks = {}};
    add_default_errors(setup.request, expected);
    return setup;
}

std::string pilot_deck(const ReferenceSetup& setup) {
    Stage settle = stage_of("settle", setup.time_step, pilot_steps);
    settle.thermostat = thermostat("langevin");
    return deck_text(spec_of(setup, 0, settle), {.title = "Pilot run: " + state_words(setup)});
}

std::string canonical_deck(const ReferenceSetup& setup, Index equilibration) {
    const ReferenceRequest& request = setup.request;
    Stage production = stage_of("production", setup.time_step, first_steps(setup, false));
    production.thermostat = thermostat("langevin");
    std::vector<Choice> analyses{analysis("cutoff_correction", {{"radius", setup.counted_radius()}, {"every", 200}}),
                                 analysis("rdf", {{"bins", 250}, {"radius", setup.counted_radius()}, {"every", 200}})};
    if (request.needs(MeasuredBy::responses)) {
        analyses.push_back(analysis("response_functions", {{"every", 50}}));
    }
    if (request.needs(MeasuredBy::insertion)) {
        analyses.push_back(analysis("chemical_potential", {{"every", 100}, {"insertions", 4 * setup.atoms}}));
    }
    if (std::ranges::find(request.properties, "structure_factor") != request.properties.end()) {
        analyses.push_back(analysis("structure_factor", {{"every", 500}}));
    }
    return deck_text(spec_of(setup, equilibration, production, std::move(analyses)),
                     {.title = "Reference: " + state_words(setup)});
}

std::string transport_deck(const ReferenceSetup& setup, Index equilibration, double total_energy) {
    const double lag = longest_lag(setup);
    Stage production = stage_of("production", transport_time_step(setup), first_steps(setup, true));
    production.total_energy = total_energy;
    const std::vector<Choice> analyses{
        analysis("msd", {{"every", 50}, {"max_time", 2.0 * lag}, {"fit_start", 0.4 * lag}}),
        analysis("viscosity", {{"every", 5}, {"max_time", lag}}),
        analysis("bulk_viscosity", {{"every", 5}, {"max_time", lag}}),
        analysis("thermal_conductivity", {{"every", 10}, {"max_time", lag}})};
    return deck_text(spec_of(setup, equilibration, production, analyses),
                     {.title = "Reference, transport: " + state_words(setup)});
}

double transport_time_step(const ReferenceSetup& setup) {
    return 0.8 * setup.time_step;
}

Index first_steps(const ReferenceSetup& setup, bool transport) {
    const Index most = setup.request.max_steps;
    if (transport) {
        return std::min(most, rounded_up(40.0 * longest_lag(setup) / transport_time_step(setup)));
    }
    const Index usual =
        setup.request.needs(MeasuredBy::responses) || setup.request.needs(MeasuredBy::insertion) ? 40'000 : 10'000;
    return std::min(most, usual);
}

}  // namespace ljmd
