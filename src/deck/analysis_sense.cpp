#include "ljmd/deck/analysis_sense.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ljmd/deck/deck_stages.hpp"
#include "ljmd/deck/mistake_report.hpp"

namespace ljmd {

namespace {

/// Analyses that compare configurations at different times measure the motion, which should be Newton's.
void check_motion(const std::vector<Section>& sections, const std::vector<Stage>& stages, Diagnostics& diagnostics) {
    for (std::size_t k = 0; k < stages.size(); ++k) {
        const Stage& stage = stages[k];
        if (stage.sample && stage.thermostat && !stage.thermostat->plugin.conserves_momentum) {
            diagnostics.warning(
                sections[k].section("thermostat").location("type"),
                fmt::format("the thermostat {} changes how atoms move: diffusion, correlation functions and "
                            "viscosity are not those of Newton's equations",
                            stage.thermostat->plugin.name));
        }
    }
}

}  // namespace

std::vector<ChosenAnalysis> chosen_analyses(const Section& analysis) {
    std::vector<ChosenAnalysis> chosen;
    for (const AnalysisMethod& method : all_analyses()) {
        if (analysis.has(method.name)) {
            chosen.push_back(choose(method, analysis.section(method.name)));
        }
    }
    return chosen;
}

void check_analyses(const Section& root, Index atoms, const Box& box, Diagnostics& diagnostics) {
    const std::vector<ChosenAnalysis> analyses = chosen_analyses(root.section("analysis"));
    const std::vector<Stage> stages = stages_of(root);
    const SampledRun run = sampled_run(stages, stages.front().seed, atoms, box);
    report(analysis_mistakes(analyses, run), root, diagnostics);
    report(sampling_mistakes(analyses, stages), root, diagnostics);
    if (std::ranges::any_of(analyses, [](const ChosenAnalysis& chosen) { return chosen.plugin.follows_time; })) {
        check_motion(root.sections("stage"), stages, diagnostics);
    }
}

}  // namespace ljmd
