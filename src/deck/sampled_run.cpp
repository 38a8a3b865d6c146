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
                   stage.has("thermostat") ? stage_temperature(stage, root) : std::nullopt,
                   std::nullopt};
    for (const Section& other : stages) {
        if (is_sampled(other)) {
            run.steps = std::max<Index>(run.steps, other.integer("steps"));
        }
    }
    return run;
}

Ensemble sampled_ensemble(const Deck& deck) {
    const auto sampled = [](const Stage& stage) { return stage.sample && stage.steps > 0; };
    const auto first = std::ranges::find_if(deck.stages, sampled);
    if (std::any_of(first, deck.stages.end(), [](const Stage& stage) { return stage.barostat.has_value(); })) {
        return Ensemble::constant_pressure;
    }
    if (std::ranges::count_if(deck.stages, sampled) != 1 || !conserves_energy(*first)) {
        return Ensemble::none;
    }
    return first->thermostat ? Ensemble::canonical : Ensemble::constant_energy;
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
