#include "engine/result_doubts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "integrators/integrator.hpp"

namespace ljmd {

namespace {

constexpr double crystal_left = 0.1;
constexpr double scatters = 5.0;

/// Fraction of the kinetic energy. A plain cut with 256 atoms, whose energy performs a random walk, reaches 0.1 % in
/// 200 tau with the usual time step. With a time step of 0.019 tau, where velocity Verlet begins to be unstable, it
/// reaches 0.6 % after 60 tau.
constexpr double large_drift = 0.003;

/// In a short stage the slope is mostly chance, and with a plain cut it follows changes of structure: only a larger
/// drift indicates the time step.
constexpr double short_stage = 5.0;  // [tau]
constexpr double large_drift_of_short_stage = 0.02;

/// In liquid argon the usual time step, 0.004, gives 0.001; a time step of 0.012 gives 0.01, and p is off by 0.04.
constexpr double small_time_step_error = 0.001;
constexpr double large_time_step_error = 0.01;
constexpr int highest_order = 2;  ///< of integrators for which TimeStepError is meaningful

void judge_stages(RunResult& result) {
    const auto kinetic = std::ranges::find(result.averages, "kinetic_energy", &ObservableAverage::name);
    for (StageResult& stage : result.stages) {
        if (stage.sampled && kinetic != result.averages.end() && kinetic->estimate) {
            stage.drift_remark = drift_remark(stage, kinetic->estimate->mean);
        }
        stage.time_step_remark = time_step_remark(stage);
    }
}

/// The stage has taken all its steps, and has not reached its errors; empty if it has, or may still.
std::string until_doubt(const StageResult& stage) {
    if (!stage.until || stage.until->reached || stage.last_step - stage.first_step < stage.until->max_steps) {
        return "";
    }
    std::vector<std::string> errors;
    errors.reserve(stage.until->errors.size());
    double longer = 1.0;
    for (const ErrorSoFar& found : stage.until->errors) {
        const double independent = std::isnan(found.independent) ? 1.0 : found.independent;
        errors.push_back(fmt::format("{} {:.2g} (wanted {:.4g}) from {:.0f} independent samples (needed {:.0f})",
                                     found.wanted.observable, found.error, found.wanted.error, independent,
                                     least_independent_samples));
        const double ratio = std::isnan(found.error) ? 1.0 : found.error / found.wanted.error;
        longer = std::max({longer, ratio * ratio, least_independent_samples / std::max(independent, 1.0)});
    }
    return fmt::format(
        "stage {} ended at its max_steps, {}, before it reached the errors wanted: {}. It takes about {:.1g} times as "
        "many steps",
        in_quotes(stage.name), stage.until->max_steps, fmt::join(errors, ", "), std::max(longer, 1.1));
}

/// Doubts about the results as a whole, and about stages.
std::vector<std::string> doubts_about(const RunResult& result, Index steps) {
    std::vector<std::string> doubts;
    if (!result.too_near.empty()) {
        doubts.push_back(result.too_near);
    }
    if (steps == 0) {
        return doubts;
    }
    if (std::ranges::all_of(result.averages, &ObservableAverage::own)) {
        doubts.emplace_back("no sample was taken: set sample = true in a stage longer than the thermo interval");
    }
    // Who measures a crystal wants it there.
    const bool of_crystal =
        std::ranges::find(result.averages, "bragg_peak", &ObservableAverage::name) != result.averages.end();
    if (result.order_at_sampling && *result.order_at_sampling > largest_molten_order(result.atoms) && !of_crystal) {
        doubts.push_back(
            fmt::format("sampling began with {:.0f} % of the crystal left (translational order {:.3f}): "
                        "equilibrate longer, or melt above the target temperature first",
                        100.0 * *result.order_at_sampling, *result.order_at_sampling));
    }
    if (const Index late = result.search.late_rebuilds; late > 0) {
        doubts.push_back(
            fmt::format("{} of {} neighbor lists were kept too long: an atom had moved by more than half the skin, "
                        "and pairs within the cutoff may have been missed. Take a larger skin or a smaller `every`, "
                        "or leave `every` out",
                        late, result.search.rebuilds));
    }
    for (const StageResult& stage : result.stages) {
        if (const std::string text = until_doubt(stage); !text.empty()) {
            doubts.push_back(text);
        }
        if (!stage.drift_remark.empty()) {
            doubts.push_back(
                fmt::format("the energy drifts in stage {}: {}", in_quotes(stage.name), stage.drift_remark));
        }
        if (!stage.time_step_remark.empty()) {
            doubts.push_back(
                fmt::format("the time step of stage '{}' is too long: {}", stage.name, stage.time_step_remark));
        }
    }
    return doubts;
}

}  // namespace

double largest_molten_order(Index atoms) {
    return std::max(crystal_left, scatters / std::sqrt(6.0 * static_cast<double>(atoms)));
}

std::string drift_remark(const StageResult& stage, double kinetic_energy) {
    const double length = static_cast<double>(stage.last_step - stage.first_step) * stage.time_step;
    const double change = stage.energy_drift.value_or(0.0) * length;
    const double limit = length < short_stage ? large_drift_of_short_stage : large_drift;
    if (!(std::abs(change) > limit * kinetic_energy)) {
        return "";
    }
    return fmt::format(
        "in all {:.2g} epsilon per atom, {:.2g} % of the kinetic energy: too much; a smaller time step, "
        "or a potential that is smooth at its cutoff, conserves it better",
        change, 100.0 * std::abs(change) / kinetic_energy);
}

std::string time_step_remark(const StageResult& stage) {
    const double error = stage.time_step_error.value_or(0.0);
    if (!(error > large_time_step_error) || find_integrator(stage.integrator).order > highest_order) {
        return "";
    }
    return fmt::format(
        "it sets the temperatures of velocities and of configurations {:.2g} % apart, in fluids 1.3 to 3 times as far, "
        "and energy and pressure are off accordingly; a time step of {:.1g} makes it {} %",
        100.0 * error, stage.time_step * std::sqrt(small_time_step_error / error), 100.0 * small_time_step_error);
}

void add_remarks(RunResult& result, const FluidSpec& spec) {
    judge_stages(result);
    for (ObservableAverage& average : result.averages) {
        if (average.name == "temperature" && average.estimate) {
            average.remark = temperature_remark(spec, average.estimate);
        }
    }
    const Index steps = total_steps(spec.stages);
    result.doubts = doubts_about(result, steps);
    result.warnings = result.doubts;
    if (const std::string unsure = unsure_of(result.averages); steps > 0 && !unsure.empty()) {
        result.warnings.push_back(
            fmt::format("the run is too short for the error bars of {}: they are guesses", unsure));
    }
}

}  // namespace ljmd
