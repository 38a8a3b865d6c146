#include "deck/few_body_sense.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "deck/deck_sense.hpp"
#include "deck/deck_stages.hpp"
#include "deck/mistake_report.hpp"
#include "engine/few_body_system.hpp"

namespace ljmd {

namespace {

std::string count(std::size_t components) {
    return fmt::format("{} component{}", components, components == 1 ? "" : "s");
}

/// The first body determines the dimension of the deck. @return nothing if vectors disagree or are invalid
std::optional<int> check_dimensions(const std::vector<Placed<BodyStart>>& bodies, Diagnostics& diagnostics) {
    std::optional<std::size_t> dimensions;
    bool agree = true;
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        const Placed<BodyStart>& body = bodies[k];
        for (const auto member : {&BodyStart::position, &BodyStart::velocity}) {
            if (!body.given(member)) {
                agree = false;
                continue;
            }
            const std::size_t components = (body.*member).size();
            if (!dimensions) {
                dimensions = components;
            } else if (components != *dimensions) {
                agree = false;
                diagnostics.error(body.location(member),
                                  fmt::format("'{}' of body {} has {}, but the deck began with {}",
                                              Placed<BodyStart>::key(member), k + 1, count(components), *dimensions),
                                  fmt::format("all vectors of this deck have {}", count(*dimensions)));
            }
        }
    }
    return agree && dimensions ? std::optional(static_cast<int>(*dimensions)) : std::nullopt;
}

bool check_force_dimensions(const Placed<BodyStart>& first_body, const FewBodyForceMethod& force, int dimensions,
                            Diagnostics& diagnostics) {
    if (dimensions >= force.min_dimensions && dimensions <= force.max_dimensions) {
        return true;
    }
    diagnostics.error(first_body.location(&BodyStart::position),
                      fmt::format("'position' has {}, but force '{}' moves a coordinate of {}",
                                  count(static_cast<std::size_t>(dimensions)), force.name,
                                  count(static_cast<std::size_t>(force.max_dimensions))));
    return false;
}

/// Whether all values of the force and all masses are valid.
bool is_sound(const FewBodyTables& tables) {
    return tables.force.section().all_sound() && std::ranges::all_of(tables.bodies, [](const Placed<BodyStart>& body) {
               return body.sound(&BodyStart::mass);
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
    const std::vector<Placed<BodyStart>>& bodies = tables.bodies;
    if (bodies.empty()) {
        return;
    }
    const auto dimensions = check_dimensions(bodies, diagnostics);
    if (!dimensions || !tables.sound(&FewBodyTables::force) || !tables.force.sound(&ForceTable::method)) {
        return;
    }
    const FewBodyForceMethod method = find_few_body_force(tables.force.method.name);
    if (!check_force_dimensions(bodies.front(), method, *dimensions, diagnostics) || !is_sound(tables)) {
        return;
    }
    const ChosenFewBodyForce force = chosen_few_body_force(tables.force.method);
    const State start = few_body_start(std::vector<BodyStart>(bodies.begin(), bodies.end()), *force.options);
    if (const auto problem = force.options->check(start)) {
        diagnostics.error(bodies[static_cast<std::size_t>(problem->body)].location(&BodyStart::position),
                          problem->message);
    }
    for (const Choice& analysis : tables.analysis.asked) {
        const auto& section = tables.analysis.section().section(analysis.name);
        if (section.all_sound()) {
            report_at_keys(chosen_few_body_analysis(analysis).options->check({start.count(), *dimensions, force}),
                           section, diagnostics);
        }
    }
}

}  // namespace ljmd
