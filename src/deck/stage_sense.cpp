#include "ljmd/deck/stage_sense.hpp"

#include "ljmd/deck/deck_stages.hpp"
#include "ljmd/deck/mistake_report.hpp"

namespace ljmd {

namespace {

/// Whether a missing temperature of [system] is allowed: a start from a file with velocities needs none. Otherwise its
/// absence is reported there.
bool system_may_lack_temperature(const Placed<FluidTables>& tables) {
    const Placed<SystemTable>& system = tables.system;
    return tables.sound(&FluidTables::system) && system.sound(&SystemTable::temperature) && !system.lattice &&
           !system.draws_velocities();
}

void check_thermostat(const Placed<FluidStageTable>& table, const Stage& stage, const Placed<FluidTables>& tables,
                      Diagnostics& diagnostics) {
    if (!stage_temperature(table, tables) && table.sound(&FluidStageTable::temperature) &&
        system_may_lack_temperature(tables)) {
        diagnostics.error(table.thermostat->location(&ThermostatTable::method),
                          "missing key 'temperature' in [[stage]]", "the thermostat needs it; or give it in [system]");
    }
    if (!stage.thermostat->plugin.canonical && stage.sample) {
        diagnostics.warning(table.location(&StageTable::sample),
                            "this stage is sampled under a thermostat that samples no ensemble");
    }
}

}  // namespace

void check_fluid_stages(const Placed<FluidTables>& tables, Diagnostics& diagnostics) {
    const std::vector<Stage> stages = stages_of(tables);
    report(stage_mistakes(stages), tables, diagnostics);
    report(fluid_stage_mistakes(stages), tables, diagnostics);
    for (std::size_t k = 0; k < stages.size(); ++k) {
        const Placed<FluidStageTable>& table = tables.stages[k];
        if (table.total_energy && table.temperature && !stages[k].thermostat) {
            diagnostics.error(table.location(&FluidStageTable::total_energy),
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
