#include "ljmd/deck/sampled_run.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ljmd/deck/stage_sense.hpp"

namespace ljmd {

namespace {

/// Analyses of the sampled stages need a box that does not change.
void check_box_stays(const std::vector<Section>& stages, Diagnostics& diagnostics) {
    bool sampled = false;
    for (const Section& stage : stages) {
        sampled = sampled || stage.flag("sample");
        if (sampled && stage.has("barostat")) {
            diagnostics.error(
                stage.location("barostat"),
                "what [analysis] asks for needs a box that stays as it is from the first sampled stage on",
                "sample a later stage without barostat, or leave [analysis] out");
        }
    }
}

/// Analyses that compare configurations at different times need equal time steps, and Newton's equations.
void check_motion(const Section& stage, const SampledRun& run, Diagnostics& diagnostics) {
    if (stage.sound("time_step") && stage.number("time_step") != run.time_step) {
        diagnostics.error(stage.location("time_step"),
                          fmt::format("sampled stages have time steps of {} and {}, but what [analysis] asks for "
                                      "compares configurations at equal times apart",
                                      run.time_step, stage.number("time_step")));
    }
    if (const auto thermostat = thermostat_method(stage); thermostat && !thermostat->conserves_momentum) {
        diagnostics.warning(
            stage.section("thermostat").location("type"),
            fmt::format("the thermostat {} changes how atoms move: diffusion, correlation functions and "
                        "viscosity are not those of Newton's equations",
                        thermostat->name));
    }
}

/// What sampled_run() needs of a stage, which may have mistakes elsewhere.
Stage sampling_of(const Section& section, const Section& root) {
    Stage stage{.name = section.text("name"),
                .time_step = section.number("time_step"),
                .steps = section.integer("steps"),
                .temperature = stage_temperature(section, root).value_or(0.0),
                .sample = section.flag("sample")};
    if (const auto method = thermostat_method(section)) {
        stage.thermostat = choose(*method);
    }
    return stage;
}

}  // namespace

SampledRun sampled_run(const Section& root, Index atoms, const Box& box) {
    std::vector<Stage> stages;
    for (const Section& section : root.sections("stage")) {
        stages.push_back(sampling_of(section, root));
    }
    const auto seed = static_cast<std::uint64_t>(root.section("system").integer("seed"));
    return sampled_run(stages, seed, atoms, box);
}

void check_analysis(const Section& root, const SampledRun& run, Diagnostics& diagnostics) {
    const Section& analysis = root.section("analysis");
    bool any = false;
    bool follows_time = false;
    for (const auto& method : all_analyses()) {
        if (!analysis.has(method.name)) {
            continue;
        }
        any = true;
        follows_time = follows_time || method.follows_time;
        const Section& section = analysis.section(method.name);
        for (const auto& [key, message] : choose(method, section).options->check(run)) {
            if (section.sound(key)) {
                diagnostics.error(section.location(key), message);
            }
        }
    }
    if (any) {
        check_box_stays(root.sections("stage"), diagnostics);
    }
    for (const Section& stage : root.sections("stage")) {
        if (follows_time && stage.flag("sample")) {
            check_motion(stage, run, diagnostics);
        }
    }
}

}  // namespace ljmd
