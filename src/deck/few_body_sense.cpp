#include "deck/few_body_sense.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck/deck_sense.hpp"
#include "deck/deck_stages.hpp"
#include "deck/mistake_report.hpp"
#include "engine/mistakes/few_body_mistakes.hpp"

namespace ljmd {

namespace {

/// The bodies, without the vectors that validation has found wrong.
std::vector<BodyStart> bodies_of(const Placed<FewBodyTables>& tables) {
    std::vector<BodyStart> bodies;
    for (const Placed<BodyStart>& body : tables.bodies) {
        BodyStart& found = bodies.emplace_back(body);
        for (const auto member : {&BodyStart::position, &BodyStart::velocity}) {
            if (!body.given(member)) {
                (found.*member).clear();
            }
        }
    }
    return bodies;
}

/// Whether all values of the force and of the bodies are valid.
bool is_sound(const FewBodyTables& tables) {
    return tables.force.section().all_sound() && std::ranges::all_of(tables.bodies, [](const Placed<BodyStart>& body) {
               return body.given(&BodyStart::position) && body.given(&BodyStart::velocity) &&
                      body.sound(&BodyStart::mass);
           });
}

void check_stages(const Placed<FewBodyTables>& tables, Diagnostics& diagnostics) {
    const std::vector<Stage> stages = stages_of(tables);
    report(stage_mistakes(stages), tables, diagnostics);
    if (!tables.analysis.asked.empty()) {
        report(few_body_sampling_mistakes(stages), tables, diagnostics);
    }
}

}  // namespace

void check_few_body_sense(const Placed<FewBodyTables>& tables, Diagnostics& diagnostics) {
    if (tables.sound(&FewBodyTables::stages)) {
        check_stages(tables, diagnostics);
    }
    const Placed<FewBodyOutputTable>& output = tables.output;
    check_directory(output.directory, output.location(&FewBodyOutputTable::directory), diagnostics);
    if (const auto& trajectory = output.trajectory;
        trajectory && trajectory->accelerations && trajectory->format != "csv") {
        diagnostics.error(trajectory->location(&TrajectoryOutput::accelerations),
                          fmt::format("'accelerations' in trajectory goes only with format = \"csv\", not \"{}\"",
                                      trajectory->format));
    }
    const std::vector<BodyStart> bodies = bodies_of(tables);
    const std::vector<Mistake> wrong_dimensions = dimension_mistakes(bodies);
    report(wrong_dimensions, tables, diagnostics);
    const bool has_force = tables.sound(&FewBodyTables::force) && tables.force.sound(&ForceTable::method);
    if (bodies.empty() || bodies.front().position.empty() || !wrong_dimensions.empty() || !has_force) {
        return;
    }
    const std::vector<Mistake> wrong_force = force_mistakes(bodies, find_few_body_force(tables.force.method.name));
    report(wrong_force, tables, diagnostics);
    if (!wrong_force.empty() || !is_sound(tables)) {
        return;
    }
    const ChosenFewBodyForce force = chosen_few_body_force(tables.force.method);
    report(start_mistakes(bodies, force), tables, diagnostics);
    std::vector<Choice> analyses = tables.analysis.asked;
    std::erase_if(analyses, [&](const Choice& analysis) {
        return !tables.analysis.section().section(analysis.name).all_sound();
    });
    report(few_body_analysis_mistakes(analyses, bodies, force), tables, diagnostics);
}

}  // namespace ljmd
