#include "ljmd/deck/start_sense.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "ljmd/deck/deck_sense.hpp"
#include "ljmd/deck/effect_sense.hpp"
#include "ljmd/deck/phase_sense.hpp"

namespace ljmd {

namespace {

/// Stages with an active thermostat.
std::vector<const Section*> held_stages(const Section& root) {
    std::vector<const Section*> held;
    for (const Section& stage : root.sections("stage")) {
        if (stage.has("thermostat") && stage.integer("steps") > 0) {
            held.push_back(&stage);
        }
    }
    return held;
}

/// `temperature` in [system] is used for drawn velocities, and for thermostats without a temperature of their own.
void check_temperature(const Section& root, bool keeps_velocities, Diagnostics& diagnostics) {
    const Section& system = root.section("system");
    const std::vector<const Section*> held = held_stages(root);
    if (!system.has("temperature") ||
        std::ranges::any_of(held, [](const Section* stage) { return !stage->has("temperature"); })) {
        return;
    }
    const double asked = system.number("temperature");
    std::vector<double> own;
    own.reserve(held.size());
    for (const Section* stage : held) {
        own.push_back(stage->number("temperature"));
    }
    const std::string of_stages =
        held.empty() ? "no stage has a thermostat"
                     : fmt::format("every stage with a thermostat has a 'temperature' of its own ({:.6g})",
                                   fmt::join(own, ", "));
    const std::string way = held.empty() ? ""
                                         : fmt::format("; --set stage.{}.temperature={:.6g} sets a stage's",
                                                       held.back()->text("name"), asked);
    if (keeps_velocities) {
        diagnostics.warning(system.location("temperature"),
                            fmt::format("'temperature' in [system] has no effect: the velocities are those of 'file', "
                                        "and {}",
                                        of_stages),
                            fmt::format("velocities = \"maxwell\" draws new ones at this temperature{}", way));
    } else if (!held.empty() && std::ranges::find(own, asked) == own.end()) {
        diagnostics.warning(system.location("temperature"),
                            fmt::format("'temperature' in [system] is {:.6g}, which only the first velocities have: {}",
                                        asked, of_stages),
                            way.substr(std::min<std::size_t>(2, way.size())));
    }
}

bool has_random_analysis(const Section& analysis) {
    return std::ranges::any_of(
        all_analyses(), [&](const AnalysisMethod& method) { return method.is_random && analysis.has(method.name); });
}

/// Random numbers are used for velocities, positions, stochastic thermostats, barostats and some analyses.
void check_seed(const Section& root, bool keeps_velocities, Diagnostics& diagnostics) {
    const Section& system = root.section("system");
    const auto is_random = [](const Section* stage) {
        return stage->has("barostat") || !find_thermostat(stage->section("thermostat").text("type")).deterministic;
    };
    if (is_written(system, "seed") && keeps_velocities && std::ranges::none_of(held_stages(root), is_random) &&
        !has_random_analysis(root.section("analysis"))) {
        diagnostics.warning(system.location("seed"),
                            "'seed' in [system] has no effect: nothing in this run is random, its velocities are those "
                            "of 'file'");
    }
}

}  // namespace

void check_start_effects(const Section& root, bool keeps_velocities, Diagnostics& diagnostics) {
    check_temperature(root, keeps_velocities, diagnostics);
    check_seed(root, keeps_velocities, diagnostics);
}

void check_start(const Deck& deck, const Start& start, Diagnostics& diagnostics) {
    check_box(deck.root, start.atoms, start.box, diagnostics);
    if (!diagnostics.has_errors()) {
        check_start_effects(deck.root, keeps_velocities(deck.system(), start), diagnostics);
        check_phase(deck, static_cast<double>(start.atoms) / start.box.volume(), diagnostics);
    }
}

}  // namespace ljmd
