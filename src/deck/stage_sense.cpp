#include "deck/stage_sense.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "deck/deck_stages.hpp"
#include "deck/mistake_report.hpp"
#include "engine/mistakes/until_mistakes.hpp"
#include "integrators/thermostat.hpp"

namespace ljmd {

namespace {

/// Whether a missing temperature of [system] is allowed: a start from a file with velocities needs none. Otherwise its
/// absence is reported there.
bool system_may_lack_temperature(const Placed<FluidTables>& tables) {
    const Placed<SystemTable>& system = tables.system;
    return tables.sound(&FluidTables::system) && system.sound(&SystemTable::temperature) && !system.lattice &&
           !system.draws_velocities();
}

void check_thermostat(const Placed<Stage>& table, const Stage& stage, const Placed<FluidTables>& tables,
                      Diagnostics& diagnostics) {
    if (!stage_temperature(table, tables) && table.sound(&Stage::temperature) && system_may_lack_temperature(tables)) {
        diagnostics.error(table.location_of_type(&Stage::thermostat), "missing key 'temperature' in [[stage]]",
                          "the thermostat needs it; or give it in [system]");
    }
    if (!find_thermostat(stage.thermostat->name).canonical && stage.sample) {
        diagnostics.warning(table.location(&Stage::sample),
                            "this stage is sampled under a thermostat that samples no ensemble");
    }
}

/// A stage has `steps` or `until`, one of both, and `until` has an error.
void check_length(const Placed<Stage>& table, Diagnostics& diagnostics) {
    if (table.absent(&Stage::until)) {
        if (table.absent(&Stage::steps)) {
            diagnostics.error(table.location(), "missing key 'steps' in [[stage]]",
                              "or 'until', for a stage that ends when errors are reached");
        }
        return;
    }
    if (table.has(&Stage::steps)) {
        diagnostics.error(table.location(&Stage::until),
                          "'until' in [[stage]] stands in place of 'steps', and both are given",
                          "leave out 'steps'; the largest number of steps is 'max_steps' in until");
    }
    if (table.sound(&Stage::until) && table.inner(&Stage::until).all_sound() && table.until.empty()) {
        std::vector<std::string> names;
        names.reserve(until_observables().size());
        for (const UntilObservable& observable : until_observables()) {
            names.push_back(observable.name);
        }
        diagnostics.error(table.location(&Stage::until), "'until' in [[stage]] has no error to reach",
                          fmt::format("it takes one or more of {}", fmt::join(names, ", ")));
    }
}

}  // namespace

void check_fluid_stages(const Placed<FluidTables>& tables, Diagnostics& diagnostics) {
    const std::vector<Stage> stages = stages_of(tables);
    report(stage_mistakes(stages), tables, diagnostics);
    report(fluid_stage_mistakes(stages), tables, diagnostics);
    report(until_mistakes(stages), tables, diagnostics);
    for (const Placed<Stage>& table : tables.stages) {
        check_length(table, diagnostics);
    }
    for (std::size_t k = 0; k < stages.size(); ++k) {
        const Placed<Stage>& table = tables.stages[k];
        if (table.total_energy && table.temperature && !table.thermostat) {
            diagnostics.error(table.location(&Stage::total_energy),
                              "'total_energy' and 'temperature' in one [[stage]]: at constant energy the temperature "
                              "is a result",
                              "leave 'temperature' out");
        }
        if (stages[k].thermostat) {
            check_thermostat(tables.stages[k], stages[k], tables, diagnostics);
        }
    }
}

}  // namespace ljmd
