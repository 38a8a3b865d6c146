#include "ljmd/deck/few_body_sense.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "ljmd/deck/deck_stages.hpp"
#include "ljmd/deck/few_body.hpp"
#include "ljmd/deck/mistake_report.hpp"
#include "ljmd/forces/few_body_force.hpp"
#include "ljmd/observables/few_body/few_body_analysis.hpp"

namespace ljmd {

namespace {

std::string count(std::size_t components) {
    return fmt::format("{} component{}", components, components == 1 ? "" : "s");
}

/// The first body determines the dimension of the deck. @return nothing if vectors disagree or are invalid
std::optional<int> check_dimensions(const std::vector<Section>& bodies, Diagnostics& diagnostics) {
    std::optional<std::size_t> dimensions;
    bool agree = true;
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        for (const char* key : {"position", "velocity"}) {
            if (!bodies[k].has(key) || !bodies[k].sound(key)) {
                agree = false;
                continue;
            }
            const std::size_t components = bodies[k].vector(key).size();
            if (!dimensions) {
                dimensions = components;
            } else if (components != *dimensions) {
                agree = false;
                diagnostics.error(bodies[k].location(key),
                                  fmt::format("'{}' of body {} has {}, but the deck began with {}", key, k + 1,
                                              count(components), *dimensions),
                                  fmt::format("all vectors of this deck have {}", count(*dimensions)));
            }
        }
    }
    return agree && dimensions ? std::optional(static_cast<int>(*dimensions)) : std::nullopt;
}

bool check_force_dimensions(const Section& root, const FewBodyForceMethod& force, int dimensions,
                            Diagnostics& diagnostics) {
    if (dimensions >= force.min_dimensions && dimensions <= force.max_dimensions) {
        return true;
    }
    diagnostics.error(root.sections("body").front().location("position"),
                      fmt::format("'position' has {}, but force '{}' moves a coordinate of {}",
                                  count(static_cast<std::size_t>(dimensions)), force.name,
                                  count(static_cast<std::size_t>(force.max_dimensions))));
    return false;
}

/// Whether all values of the force and all masses are valid.
bool is_sound(const Section& root, const FewBodyForceMethod& force) {
    const Section& section = root.section("force");
    for (const Key& key : keys_of(force)) {
        if (!section.sound(key.name)) {
            return false;
        }
    }
    for (const Section& body : root.sections("body")) {
        if (!body.sound("mass")) {
            return false;
        }
    }
    return true;
}

void check_stages(const Section& root, Diagnostics& diagnostics) {
    const std::vector<Stage> stages = stages_of(root);
    report(stage_mistakes(stages), root, diagnostics);
    const std::vector<FewBodyAnalysisMethod> methods = all_few_body_analyses();
    if (std::ranges::any_of(methods, [&](const auto& method) { return root.section("analysis").has(method.name); })) {
        report(few_body_sampling_mistakes(stages), root, diagnostics);
    }
}

void check_analyses(const Section& root, const FewBodyTarget& target, Diagnostics& diagnostics) {
    const Section& analysis = root.section("analysis");
    for (const auto& method : all_few_body_analyses()) {
        if (!analysis.has(method.name)) {
            continue;
        }
        const Section& section = analysis.section(method.name);
        for (const auto& [key, message] : choose(method, section).options->check(target)) {
            if (section.sound(key)) {
                diagnostics.error(section.location(key), message);
            }
        }
    }
}

}  // namespace

void check_few_body_sense(const Section& root, Diagnostics& diagnostics) {
    if (root.has("stage") && root.sound("stage")) {
        check_stages(root, diagnostics);
    }
    const Section& output = root.section("output");
    if (output.has("directory") && output.text("directory").empty()) {
        diagnostics.error(output.location("directory"), "'directory' in [output] is empty");
    }
    if (output.has("trajectory")) {
        const Section& trajectory = output.section("trajectory");
        if (trajectory.flag("accelerations") && trajectory.text("format") != "csv") {
            diagnostics.error(trajectory.location("accelerations"),
                              fmt::format("'accelerations' in trajectory goes only with format = \"csv\", not \"{}\"",
                                          trajectory.text("format")));
        }
    }
    if (!root.has("body") || root.sections("body").empty()) {
        return;
    }
    const auto dimensions = check_dimensions(root.sections("body"), diagnostics);
    if (!dimensions || !root.has("force") || !root.sound("force") || !root.section("force").sound("type")) {
        return;
    }
    const FewBodyForceMethod method = find_few_body_force(root.section("force").text("type"));
    if (!check_force_dimensions(root, method, *dimensions, diagnostics) || !is_sound(root, method)) {
        return;
    }
    const ChosenFewBodyForce force = choose(method, root.section("force"));
    const std::vector<Section>& bodies = root.sections("body");
    const State start = few_body_start(bodies, *force.options);
    if (const auto problem = force.options->check(start)) {
        diagnostics.error(bodies[static_cast<std::size_t>(problem->body)].location("position"), problem->message);
    }
    check_analyses(root, {start.count(), *dimensions, force}, diagnostics);
}

}  // namespace ljmd
