#include "deck/effect_sense.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "forces/few_body_force.hpp"
#include "neighbors/verlet_list.hpp"

namespace ljmd {

namespace {

/// The steps of a stage: first < n <= last.
template <class AnyStage>
struct StageSteps {
    const Placed<AnyStage>& stage;
    Index first;
    Index last;

    [[nodiscard]] Index count() const { return last - first; }
    /// Whether a multiple of `every`, in steps of the run, is in this stage.
    [[nodiscard]] bool has_multiple_of(Index every) const { return last / every > first / every; }
};

template <class AnyStage>
std::vector<StageSteps<AnyStage>> steps_of_stages(const std::vector<Placed<AnyStage>>& stages) {
    std::vector<StageSteps<AnyStage>> found;
    Index step = 0;
    for (const Placed<AnyStage>& stage : stages) {
        found.push_back({stage, step, step + stage.steps});
        step = found.back().last;
    }
    return found;
}

std::string steps_in_words(Index steps) {
    return fmt::format("{} step{}", steps, steps == 1 ? "" : "s");
}

using FluidStageSteps = StageSteps<Stage>;

/// Warn if a thermostat or barostat never acts because its interval is longer than the stage.
void check_acts(const FluidStageSteps& steps, std::optional<Choice> Stage::*bath, Diagnostics& diagnostics) {
    const auto interval = steps.stage.*bath ? steps.stage.inner(bath).step_interval() : std::nullopt;
    if (interval && steps.count() > 0 && interval->every > steps.count()) {
        diagnostics.warning(
            interval->location,
            fmt::format("the {} of stage '{}' never acts: it does so every {}, and the stage has {}",
                        Placed<Stage>::key(bath), steps.stage.name, steps_in_words(interval->every), steps.count()));
    }
}

void check_stage(const FluidStageSteps& steps, Diagnostics& diagnostics) {
    const Placed<Stage>& stage = steps.stage;
    if (stage.temperature && !stage.thermostat && !stage.total_energy) {
        diagnostics.warning(stage.location(&Stage::temperature),
                            "'temperature' in [[stage]] has no effect without a thermostat");
    }
    check_acts(steps, &Stage::thermostat, diagnostics);
    check_acts(steps, &Stage::barostat, diagnostics);
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
                steps.stage.location(&Stage::sample),
                fmt::format("stage '{}' adds nothing to the averages: samples are the rows of thermo.csv, every {} of "
                            "the run, and none falls into its {}",
                            steps.stage.name, steps_in_words(thermo_every), steps_in_words(steps.count())),
                "'every' of thermo in [output] sets them");
        }
    }
    const FluidStageSteps& last = stages.back();
    if (!last.stage.until.empty() && last.count() / thermo_every < first_look) {
        diagnostics.warning(last.stage.location(&Stage::until),
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
    for (const Choice& analysis : analyses) {
        if (const auto interval = tables.analysis.section().section(analysis.name).step_interval()) {
            check_analysis_looks(*interval, analysis.name, stages, diagnostics);
        }
    }
    check_trajectory(tables.output.trajectory, stages.back().last, diagnostics);
}

void check_few_body_effects(const FewBodyTables& tables, Diagnostics& diagnostics) {
    const auto stages = steps_of_stages(tables.stages);
    if (tables.analysis.asked.empty()) {
        for (const Placed<FewBodyStage>& stage : tables.stages) {
            if (stage.written(&Stage::sample)) {
                diagnostics.warning(stage.location(&Stage::sample),
                                    "'sample' in [[stage]] has no effect without [analysis]");
            }
        }
    } else if (std::ranges::none_of(tables.stages, &Stage::sample)) {
        warn_of_no_sampling(tables.stages.back().location(), "nothing of what [analysis] asks for will be found",
                            diagnostics);
    }
    const auto& force = tables.force;
    const auto bodies = static_cast<Index>(tables.bodies.size());
    for (const auto& [key, message] : chosen_few_body_force(force.method).options->without_effect(bodies)) {
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
