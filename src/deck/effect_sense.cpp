#include "ljmd/deck/effect_sense.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/neighbors/verlet_list.hpp"

namespace ljmd {

namespace {

/// The steps of a stage: first < n <= last.
template <class Stage>
struct StageSteps {
    const Placed<Stage>& stage;
    Index first;
    Index last;

    [[nodiscard]] Index count() const { return last - first; }
    /// Whether a multiple of `every`, in steps of the run, is in this stage.
    [[nodiscard]] bool has_multiple_of(Index every) const { return last / every > first / every; }
};

Index most_steps(const FluidStageTable& stage) {
    return stage.most_steps();
}
Index most_steps(const FewBodyStageTable& stage) {
    return stage.steps;
}

template <class Stage>
std::vector<StageSteps<Stage>> steps_of_stages(const std::vector<Placed<Stage>>& stages) {
    std::vector<StageSteps<Stage>> found;
    Index step = 0;
    for (const Placed<Stage>& stage : stages) {
        found.push_back({stage, step, step + most_steps(stage)});
        step = found.back().last;
    }
    return found;
}

std::string steps_in_words(Index steps) {
    return fmt::format("{} step{}", steps, steps == 1 ? "" : "s");
}

using FluidStageSteps = StageSteps<FluidStageTable>;

/// Warn if a thermostat or barostat never acts because its interval is longer than the stage.
template <class Bath>
void check_acts(const FluidStageSteps& steps, const std::optional<Placed<Bath>>& bath, const std::string& name,
                Diagnostics& diagnostics) {
    const auto interval = bath ? bath->section().step_interval() : std::nullopt;
    if (interval && steps.count() > 0 && interval->every > steps.count()) {
        diagnostics.warning(interval->location,
                            fmt::format("the {} of stage '{}' never acts: it does so every {}, and the stage has {}",
                                        name, steps.stage.name, steps_in_words(interval->every), steps.count()));
    }
}

void check_stage(const FluidStageSteps& steps, Diagnostics& diagnostics) {
    const Placed<FluidStageTable>& stage = steps.stage;
    if (stage.temperature && !stage.thermostat && !stage.total_energy) {
        diagnostics.warning(stage.location(&FluidStageTable::temperature),
                            "'temperature' in [[stage]] has no effect without a thermostat");
    }
    check_acts(steps, stage.thermostat, Placed<FluidStageTable>::key(&FluidStageTable::thermostat), diagnostics);
    check_acts(steps, stage.barostat, Placed<FluidStageTable>::key(&FluidStageTable::barostat), diagnostics);
}

/// Warn that no stage is sampled, at the last one, which is usually the one that was meant.
void warn_of_no_sampling(const Location& last_stage, const std::string& what, Diagnostics& diagnostics) {
    diagnostics.warning(last_stage, fmt::format("no stage is sampled: {}", what),
                        "sample = true in the stage that is to be measured");
}

void check_sampling(const std::vector<FluidStageSteps>& stages, Index thermo_every, bool analysed,
                    Diagnostics& diagnostics) {
    bool sampled = false;
    for (const FluidStageSteps& steps : stages) {
        if (!steps.stage.sample) {
            continue;
        }
        sampled = true;
        if (!steps.has_multiple_of(thermo_every)) {
            diagnostics.warning(
                steps.stage.location(&StageTable::sample),
                fmt::format("stage '{}' adds nothing to the averages: samples are the rows of thermo.csv, every {} of "
                            "the run, and none falls into its {}",
                            steps.stage.name, steps_in_words(thermo_every), steps_in_words(steps.count())),
                "'every' of thermo in [output] sets them");
        }
    }
    const FluidStageSteps& last = stages.back();
    if (last.stage.until && last.count() / thermo_every < first_look) {
        diagnostics.warning(last.stage.location(&FluidStageTable::until),
                            fmt::format("stage '{}' cannot end before its max_steps: errors are first looked at after "
                                        "{} samples, and it has {}",
                                        last.stage.name, first_look, last.count() / thermo_every));
    }
    if (!sampled) {
        warn_of_no_sampling(
            stages.back().stage.location(),
            fmt::format("there will be no averages{}", analysed ? ", and nothing of what [analysis] asks for" : ""),
            diagnostics);
    }
}

/// Warn if an analysis with an interval in steps of the run never sees a sampled stage.
void check_analysis_looks(const StepInterval& interval, const std::string& name,
                          const std::vector<FluidStageSteps>& stages, Diagnostics& diagnostics) {
    const auto is_sampled = [](const FluidStageSteps& steps) { return steps.stage.sample; };
    const auto is_seen = [&](const FluidStageSteps& steps) {
        return is_sampled(steps) && steps.has_multiple_of(interval.every);
    };
    if (std::ranges::any_of(stages, is_sampled) && std::ranges::none_of(stages, is_seen)) {
        diagnostics.warning(interval.location,
                            fmt::format("'{}' in [analysis] measures nothing: it looks every {} of the run, and none "
                                        "falls into a sampled stage",
                                        name, steps_in_words(interval.every)),
                            "give a smaller 'every'");
    }
}

template <class Trajectory>
void check_trajectory(const std::optional<Placed<Trajectory>>& trajectory, Index steps, Diagnostics& diagnostics) {
    if (trajectory && trajectory->every > steps) {
        diagnostics.warning(trajectory->location(&TrajectoryOutput::every),
                            fmt::format("the trajectory will hold the start alone: its frames come every {}, and the "
                                        "run has {}",
                                        steps_in_words(trajectory->every), steps));
    }
}

}  // namespace

void check_effects(const FluidTables& tables, Diagnostics& diagnostics) {
    const Placed<NeighborSpec>& neighbors = tables.neighbors;
    if (!neighbors.keeps_list() && neighbors.written(&NeighborSpec::skin)) {
        diagnostics.warning(neighbors.location(&NeighborSpec::skin),
                            fmt::format("'skin' in [neighbors] has no effect with method = \"{}\"", neighbors.method),
                            fmt::format("only {} keeps a list", VerletList::name));
    }
    const std::vector<FluidStageSteps> stages = steps_of_stages(tables.stages);
    for (const FluidStageSteps& steps : stages) {
        check_stage(steps, diagnostics);
    }
    if (stages.back().last == 0) {
        return;  // the start is evaluated once, and sampled
    }
    const auto& analyses = tables.analysis.asked;
    check_sampling(stages, tables.output.thermo.every, !analyses.empty(), diagnostics);
    for (const auto& [chosen, section] : analyses) {
        if (const auto interval = section.step_interval()) {
            check_analysis_looks(*interval, chosen.plugin.name, stages, diagnostics);
        }
    }
    check_trajectory(tables.output.trajectory, stages.back().last, diagnostics);
}

void check_few_body_effects(const FewBodyTables& tables, Diagnostics& diagnostics) {
    const auto stages = steps_of_stages(tables.stages);
    if (tables.analysis.asked.empty()) {
        for (const Placed<FewBodyStageTable>& stage : tables.stages) {
            if (stage.written(&StageTable::sample)) {
                diagnostics.warning(stage.location(&StageTable::sample),
                                    "'sample' in [[stage]] has no effect without [analysis]");
            }
        }
    } else if (std::ranges::none_of(tables.stages, &StageTable::sample)) {
        warn_of_no_sampling(tables.stages.back().location(), "nothing of what [analysis] asks for will be found",
                            diagnostics);
    }
    const auto& force = tables.force;
    const auto bodies = static_cast<Index>(tables.bodies.size());
    for (const auto& [key, message] : force.method.options->without_effect(bodies)) {
        diagnostics.warning(force.section().location(key), message);
    }
    const auto& trajectory = tables.output.trajectory;
    if (trajectory && trajectory->format == "csv" && trajectory->written(&TrajectoryOutput::velocities) &&
        !trajectory->velocities) {
        diagnostics.warning(trajectory->location(&TrajectoryOutput::velocities),
                            "'velocities' in trajectory has no effect: format = \"csv\" always has them");
    }
    if (stages.back().last > 0) {
        check_trajectory(trajectory, stages.back().last, diagnostics);
    }
}

}  // namespace ljmd
