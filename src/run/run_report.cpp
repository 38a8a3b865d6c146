#include "run/run_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "integrators/integrator.hpp"

namespace ljmd {

namespace {

constexpr std::size_t longest_title = 200;

}  // namespace

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
    if (const auto& start = stage.energy_start) {
        json["energy_start"] = {{"total_energy", start->total_energy},
                                {"potential_energy", start->potential_energy},
                                {"kinetic_energy_before", start->kinetic_before},
                                {"velocity_factor", start->velocity_factor}};
    }
    if (stage.until) {
        Data wanted = Data::object();
        Data errors = Data::object();
        for (const ErrorSoFar& found : stage.until->errors) {
            wanted[found.wanted.observable] = found.wanted.error;
            errors[found.wanted.observable] = found.error;
        }
        json["until"] = {{"wanted", wanted},
                         {"errors", errors},
                         {"max_steps", stage.until->max_steps},
                         {"reached", stage.until->reached}};
    }
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
        if (const auto& start = stage.energy_start) {
            const std::string line = fmt::format("  stage {} began at E/N = {:.10g}: velocities multiplied by {:.6g}",
                                                 in_quotes(stage.name), start->total_energy, start->velocity_factor);
            text += wrapped(line, screen_columns, 4) + '\n';
        }
        if (stage.energy_drift) {
            const std::string line = fmt::format("  energy drift in stage {}: {:.2g} {}", in_quotes(stage.name),
                                                 *stage.energy_drift, drift_unit);
            text += wrapped(line, screen_columns, 4) + '\n';
        }
    }
    for (const StageResult& stage : stages) {
        if (stage.until && stage.until->reached) {
            const Index steps = stage.last_step - stage.first_step;
            const std::string line = fmt::format(
                "  stage {} reached the errors wanted: it took {}{} steps", in_quotes(stage.name), steps,
                steps < stage.until->max_steps ? fmt::format(" of at most {}", stage.until->max_steps) : "");
            text += wrapped(line, screen_columns, 4) + '\n';
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

std::string title_line(const RunPlan& plan) {
    return wrapped(printable(plan.title.empty() ? plan.path : plan.title, longest_title), screen_columns, 0);
}

}  // namespace ljmd
