#include "deck/analysis_sense.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck/deck_stages.hpp"
#include "deck/mistake_report.hpp"
#include "engine/mistakes/film_mistakes.hpp"
#include "integrators/thermostat.hpp"
#include "ljmd/detail/observables/analysis.hpp"

namespace ljmd {

namespace {

/// Analyses that compare configurations at different times measure the motion, which should be Newton's.
void check_motion(const std::vector<Placed<Stage>>& tables, const std::vector<Stage>& stages,
                  Diagnostics& diagnostics) {
    for (std::size_t k = 0; k < stages.size(); ++k) {
        const Stage& stage = stages[k];
        if (stage.sample && stage.thermostat && !find_thermostat(stage.thermostat->name).conserves_momentum) {
            diagnostics.warning(
                tables[k].location_of_type(&Stage::thermostat),
                fmt::format("the thermostat {} changes how atoms move: diffusion, correlation functions and "
                            "viscosity are not those of Newton's equations",
                            stage.thermostat->name));
        }
    }
}

}  // namespace

void check_analyses(const Placed<FluidTables>& tables, Index atoms, const Box& box, Diagnostics& diagnostics) {
    std::vector<Choice> analyses = tables.analysis.asked;
    std::erase_if(analyses, [&tables](const Choice& analysis) {
        return !tables.analysis.section().section(analysis.name).all_sound();
    });
    const std::vector<Stage> stages = stages_of(tables);
    const SampledRun run = sampled_run(stages, stages.front().seed, atoms, box);
    report(analysis_mistakes(analyses, run), tables, diagnostics);
    report(sampling_mistakes(analyses, stages), tables, diagnostics);
    report(analysis_need_mistakes(analyses, tables.potential.truncation, stages), tables, diagnostics);
    report(homogeneity_mistakes(analyses, tables.system.is_film()), tables, diagnostics);
    if (std::ranges::any_of(analyses,
                            [](const Choice& analysis) { return find_analysis(analysis.name).follows_time; })) {
        check_motion(tables.stages, stages, diagnostics);
    }
}

}  // namespace ljmd
