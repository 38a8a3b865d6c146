#include "deck/start_sense.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "deck/deck_sense.hpp"
#include "deck/phase_sense.hpp"
#include "integrators/thermostat.hpp"
#include "ljmd/detail/observables/analysis.hpp"

namespace ljmd {

namespace {

/// Stages with an active thermostat.
std::vector<const Placed<Stage>*> held_stages(const FluidTables& tables) {
    std::vector<const Placed<Stage>*> held;
    for (const Placed<Stage>& stage : tables.stages) {
        if (stage.thermostat && stage.steps > 0) {
            held.push_back(&stage);
        }
    }
    return held;
}

/// `temperature` in [system] is used for drawn velocities, and for thermostats without a temperature of their own.
void check_temperature(const FluidTables& tables, bool keeps_velocities, Diagnostics& diagnostics) {
    const Placed<SystemTable>& system = tables.system;
    const auto held = held_stages(tables);
    if (!system.temperature || std::ranges::any_of(held, [](const auto* stage) { return !stage->temperature; })) {
        return;
    }
    const double asked = *system.temperature;
    std::vector<double> own;
    own.reserve(held.size());
    for (const auto* stage : held) {
        own.push_back(*stage->temperature);
    }
    const std::string of_stages =
        held.empty() ? "no stage has a thermostat"
                     : fmt::format("every stage with a thermostat has a 'temperature' of its own ({:.6g})",
                                   fmt::join(own, ", "));
    const std::string way =
        held.empty() ? "" : fmt::format("; --set stage.{}.temperature={:.6g} sets a stage's", held.back()->name, asked);
    if (keeps_velocities) {
        diagnostics.warning(system.location(&SystemTable::temperature),
                            fmt::format("'temperature' in [system] has no effect: the velocities are those of 'file', "
                                        "and {}",
                                        of_stages),
                            fmt::format("velocities = \"maxwell\" draws new ones at this temperature{}", way));
    } else if (!held.empty() && std::ranges::find(own, asked) == own.end()) {
        diagnostics.warning(system.location(&SystemTable::temperature),
                            fmt::format("'temperature' in [system] is {:.6g}, which only the first velocities have: {}",
                                        asked, of_stages),
                            way.substr(std::min<std::size_t>(2, way.size())));
    }
}

/// Random numbers are used for velocities, positions, stochastic thermostats, barostats and some analyses.
void check_seed(const FluidTables& tables, bool keeps_velocities, Diagnostics& diagnostics) {
    const Placed<SystemTable>& system = tables.system;
    const auto is_random = [](const auto* stage) {
        return stage->barostat || !find_thermostat(stage->thermostat->name).deterministic;
    };
    const bool random_analysis = std::ranges::any_of(
        tables.analysis.asked, [](const Choice& analysis) { return find_analysis(analysis.name).is_random; });
    if (system.written(&SystemTable::seed) && keeps_velocities &&
        std::ranges::none_of(held_stages(tables), is_random) && !random_analysis) {
        diagnostics.warning(system.location(&SystemTable::seed),
                            "'seed' in [system] has no effect: nothing in this run is random, its velocities are those "
                            "of 'file'");
    }
}

}  // namespace

void check_start_effects(const FluidTables& tables, bool keeps_velocities, Diagnostics& diagnostics) {
    check_temperature(tables, keeps_velocities, diagnostics);
    check_seed(tables, keeps_velocities, diagnostics);
}

void check_start(const Deck& deck, const Start& start, Diagnostics& diagnostics) {
    if (start.configuration) {
        for (const std::string& remark : start.configuration->remarks) {
            diagnostics.warning(deck.fluid().system.location(&SystemTable::file),
                                fmt::format("{}: {}", *deck.system().file, remark));
        }
    }
    check_box(deck.fluid(), start.atoms, start.box, diagnostics);
    if (!diagnostics.has_errors()) {
        check_start_effects(deck.fluid(), keeps_velocities(deck.system(), start), diagnostics);
        check_phase(deck, static_cast<double>(start.atoms) / start.box.volume(), diagnostics);
    }
}

}  // namespace ljmd
