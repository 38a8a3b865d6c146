#include "ljmd/deck/effect_sense.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "ljmd/observables/analysis.hpp"
#include "ljmd/observables/few_body/few_body_analysis.hpp"

namespace ljmd {

namespace {

/// The steps of a stage: first < n <= last.
struct StageSteps {
    const Section& stage;
    Index first;
    Index last;

    [[nodiscard]] Index count() const { return last - first; }
    /// Whether a multiple of `every`, in steps of the run, is in this stage.
    [[nodiscard]] bool has_multiple_of(Index every) const { return last / every > first / every; }
};

std::vector<StageSteps> steps_of_stages(const Section& root) {
    std::vector<StageSteps> found;
    Index step = 0;
    for (const Section& stage : root.sections("stage")) {
        found.push_back({stage, step, step + stage.integer("steps")});
        step = found.back().last;
    }
    return found;
}

std::string steps_in_words(Index steps) {
    return fmt::format("{} step{}", steps, steps == 1 ? "" : "s");
}

/// The interval of an output in [output], or the default.
Index interval(const Section& output, const char* what, Index usual) {
    return output.has(what) ? output.section(what).integer("every") : usual;
}

/// Warn if a thermostat or barostat never acts because its interval is longer than the stage.
void check_acts(const StageSteps& steps, const char* bath, Diagnostics& diagnostics) {
    if (steps.count() == 0 || !steps.stage.has(bath) || !steps.stage.section(bath).has("every")) {
        return;
    }
    const Section& section = steps.stage.section(bath);
    if (const Index every = section.integer("every"); every > steps.count()) {
        diagnostics.warning(section.location("every"),
                            fmt::format("the {} of stage '{}' never acts: it does so every {}, and the stage has {}",
                                        bath, steps.stage.text("name"), steps_in_words(every), steps.count()));
    }
}

void check_stage(const StageSteps& steps, Diagnostics& diagnostics) {
    if (steps.stage.has("temperature") && !steps.stage.has("thermostat")) {
        diagnostics.warning(steps.stage.location("temperature"),
                            "'temperature' in [[stage]] has no effect without a thermostat");
    }
    check_acts(steps, "thermostat", diagnostics);
    check_acts(steps, "barostat", diagnostics);
}

/// Warn that no stage is sampled, at the last one, which is usually the one that was meant.
void warn_of_no_sampling(const StageSteps& last, const std::string& what, Diagnostics& diagnostics) {
    diagnostics.warning(last.stage.location(), fmt::format("no stage is sampled: {}", what),
                        "sample = true in the stage that is to be measured");
}

void check_sampling(const std::vector<StageSteps>& stages, Index thermo_every, bool analysed,
                    Diagnostics& diagnostics) {
    bool sampled = false;
    for (const StageSteps& steps : stages) {
        if (!steps.stage.flag("sample")) {
            continue;
        }
        sampled = true;
        if (!steps.has_multiple_of(thermo_every)) {
            diagnostics.warning(
                steps.stage.location("sample"),
                fmt::format("stage '{}' adds nothing to the averages: samples are the rows of thermo.csv, every {} of "
                            "the run, and none falls into its {}",
                            steps.stage.text("name"), steps_in_words(thermo_every), steps_in_words(steps.count())),
                "'every' of thermo in [output] sets them");
        }
    }
    if (!sampled) {
        warn_of_no_sampling(
            stages.back(),
            fmt::format("there will be no averages{}", analysed ? ", and nothing of what [analysis] asks for" : ""),
            diagnostics);
    }
}

/// Warn if an analysis with an interval in steps of the run never sees a sampled stage.
void check_analysis_looks(const Section& section, const std::string& name, const std::vector<StageSteps>& stages,
                          Diagnostics& diagnostics) {
    if (!section.has("every")) {
        return;
    }
    const Index every = section.integer("every");
    const auto is_sampled = [](const StageSteps& steps) { return steps.stage.flag("sample"); };
    const auto is_seen = [&](const StageSteps& steps) { return is_sampled(steps) && steps.has_multiple_of(every); };
    if (std::ranges::any_of(stages, is_sampled) && std::ranges::none_of(stages, is_seen)) {
        diagnostics.warning(section.location("every"),
                            fmt::format("'{}' in [analysis] measures nothing: it looks every {} of the run, and none "
                                        "falls into a sampled stage",
                                        name, steps_in_words(every)),
                            "give a smaller 'every'");
    }
}

/// The names of the analyses that [analysis] asks for.
template <class Method>
std::vector<std::string> asked_for(const Section& analysis, const std::vector<Method>& methods) {
    std::vector<std::string> names;
    for (const Method& method : methods) {
        if (analysis.has(method.name)) {
            names.push_back(method.name);
        }
    }
    return names;
}

void check_trajectory(const Section& output, Index steps, Diagnostics& diagnostics) {
    if (!output.has("trajectory")) {
        return;
    }
    const Section& trajectory = output.section("trajectory");
    if (const Index every = trajectory.integer("every"); every > steps) {
        diagnostics.warning(trajectory.location("every"),
                            fmt::format("the trajectory will hold the start alone: its frames come every {}, and the "
                                        "run has {}",
                                        steps_in_words(every), steps));
    }
}

}  // namespace

bool is_written(const Section& section, const std::string& key) {
    // A default value has the location of its table.
    const Location value = section.location(key);
    const Location& table = section.location();
    return section.has(key) &&
           std::tie(value.source, value.line, value.column) != std::tie(table.source, table.line, table.column);
}

void check_effects(const Section& root, Diagnostics& diagnostics) {
    const Section& neighbors = root.section("neighbors");
    if (neighbors.text("method") != "verlet-list" && is_written(neighbors, "skin")) {
        diagnostics.warning(
            neighbors.location("skin"),
            fmt::format("'skin' in [neighbors] has no effect with method = \"{}\"", neighbors.text("method")),
            "only verlet-list keeps a list");
    }
    const std::vector<StageSteps> stages = steps_of_stages(root);
    for (const StageSteps& steps : stages) {
        check_stage(steps, diagnostics);
    }
    if (stages.back().last == 0) {
        return;  // the start is evaluated once, and sampled
    }
    const Section& output = root.section("output");
    const Section& analysis = root.section("analysis");
    const std::vector<std::string> analyses = asked_for(analysis, all_analyses());
    check_sampling(stages, interval(output, "thermo", 10), !analyses.empty(), diagnostics);
    for (const std::string& name : analyses) {
        check_analysis_looks(analysis.section(name), name, stages, diagnostics);
    }
    check_trajectory(output, stages.back().last, diagnostics);
}

void check_few_body_effects(const Section& root, Diagnostics& diagnostics) {
    const std::vector<StageSteps> stages = steps_of_stages(root);
    const std::vector<std::string> analyses = asked_for(root.section("analysis"), all_few_body_analyses());
    if (analyses.empty()) {
        for (const StageSteps& steps : stages) {
            if (is_written(steps.stage, "sample")) {
                diagnostics.warning(steps.stage.location("sample"),
                                    "'sample' in [[stage]] has no effect without [analysis]");
            }
        }
    } else if (std::ranges::none_of(stages, [](const StageSteps& steps) { return steps.stage.flag("sample"); })) {
        warn_of_no_sampling(stages.back(), "nothing of what [analysis] asks for will be found", diagnostics);
    }
    const Section& force = root.section("force");
    if (force.text("type") == "newtonian-gravity" && root.sections("body").size() == 1 &&
        force.number("central_mass") == 0.0) {
        diagnostics.warning(force.location("gravitational_constant"),
                            "gravity has no effect on a single body without 'central_mass': it moves straight on");
    }
    const Section& output = root.section("output");
    if (output.has("trajectory")) {
        const Section& trajectory = output.section("trajectory");
        if (trajectory.text("format") == "csv" && is_written(trajectory, "velocities") &&
            !trajectory.flag("velocities")) {
            diagnostics.warning(trajectory.location("velocities"),
                                "'velocities' in trajectory has no effect: format = \"csv\" always has them");
        }
    }
    if (stages.back().last > 0) {
        check_trajectory(output, stages.back().last, diagnostics);
    }
}

}  // namespace ljmd
