#include "ljmd/app/sampled_run.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ljmd {

namespace {

/// What the thermostat of a stage holds, if it has one.
std::optional<double> held_temperature(const Section& stage, const Section& system) {
    if (!stage.has("thermostat")) {
        return std::nullopt;
    }
    const Section& from = stage.has("temperature") ? stage : system;
    return from.has("temperature") ? std::optional(from.number("temperature")) : std::nullopt;
}

}  // namespace

SampledRun sampled_run(const Section& root, Index atoms, const Box& box) {
    const std::vector<Section>& stages = root.sections("stage");
    const auto is_sampled = [](const Section& stage) { return stage.flag("sample"); };
    const auto first = std::ranges::find_if(stages, is_sampled);
    const Section& stage = first == stages.end() ? stages.back() : *first;
    const Section& system = root.section("system");
    SampledRun run{atoms,
                   box,
                   stage.number("time_step"),
                   stage.integer("steps"),
                   static_cast<std::uint64_t>(system.integer("seed")),
                   held_temperature(stage, system),
                   std::nullopt};
    for (const Section& other : stages) {
        if (is_sampled(other)) {
            run.steps = std::max<Index>(run.steps, other.integer("steps"));
        }
    }
    return run;
}

void check_analysis(const Section& root, const SampledRun& run, Diagnostics& diagnostics) {
    const Section& analysis = root.section("analysis");
    bool follows_time = false;
    for (const auto& method : all_analyses()) {
        if (!analysis.has(method.name)) {
            continue;
        }
        follows_time = follows_time || method.follows_time;
        const Section& section = analysis.section(method.name);
        for (const auto& [key, message] : method.check(section, run)) {
            if (section.sound(key)) {
                diagnostics.error(section.location(key), message);
            }
        }
    }
    if (!follows_time) {
        return;
    }
    for (const Section& stage : root.sections("stage")) {
        if (stage.flag("sample") && stage.sound("time_step") && stage.number("time_step") != run.time_step) {
            diagnostics.error(stage.location("time_step"),
                              fmt::format("sampled stages have time steps of {} and {}, but what [analysis] asks for "
                                          "compares configurations at equal times apart",
                                          run.time_step, stage.number("time_step")));
        }
    }
}

}  // namespace ljmd
