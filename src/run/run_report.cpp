#include "ljmd/run/run_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ljmd/core/text.hpp"
#include "ljmd/integrators/integrator.hpp"

namespace ljmd {

namespace {

constexpr std::size_t longest_title = 200;

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

}  // namespace

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
        "it sets the temperatures of velocities and of configurations {:.2g} % apart, and energy and pressure are off "
        "accordingly; a time step of {:.1g} makes it {} %",
        100.0 * error, stage.time_step * std::sqrt(small_time_step_error / error), 100.0 * small_time_step_error);
}

Data stage_data(const StageResult& stage) {
    Data json = {{"name", stage.name},
                 {"integrator", stage.integrator},
                 {"first_step", stage.first_step},
                 {"last_step", stage.last_step},
                 {"steps", stage.last_step - stage.first_step},
                 {"time_step", stage.time_step},
                 {"sampled", stage.sampled},
                 {"thermostat", stage.thermostatted},
                 {"reversed", stage.reversed},
                 {"energy_drift", stage.energy_drift},
                 {"time_step_error", stage.time_step_error},
                 {"checksum_at_start", stage.checksum_at_start},
                 {"checksum_at_end", stage.checksum_at_end}};
    if (!stage.drift_remark.empty()) {
        json["energy_drift_remark"] = stage.drift_remark;
    }
    if (!stage.time_step_remark.empty()) {
        json["time_step_remark"] = stage.time_step_remark;
    }
    return json;
}

std::string stage_lines(const std::vector<StageResult>& stages, const std::string& drift_unit) {
    std::string text;
    for (const StageResult& stage : stages) {
        if (stage.energy_drift) {
            text += fmt::format("  energy drift in stage {}: {:.2g} {}{}\n", in_quotes(stage.name), *stage.energy_drift,
                                drift_unit, stage.drift_remark.empty() ? "" : ",\n    " + stage.drift_remark);
        }
        if (!stage.time_step_remark.empty()) {
            text +=
                fmt::format("  the time step of stage '{}' is too long:\n    {}\n", stage.name, stage.time_step_remark);
        }
    }
    const auto reversed = std::find_if(stages.begin(), stages.end(), [](const auto& stage) { return stage.reversed; });
    if (reversed != stages.end()) {
        text += fmt::format("  checksum of all positions: {} at the start\n", stages.front().checksum_at_start);
        for (const StageResult& stage : stages) {
            text += fmt::format("                             {} after stage {}\n", stage.checksum_at_end,
                                in_quotes(stage.name));
        }
    }
    return text;
}

std::string title_line(const Deck& deck) {
    return printable(deck.title.empty() ? deck.path : deck.title, longest_title);
}

}  // namespace ljmd
