#include "ljmd/deck/deck_stages.hpp"

#include "ljmd/engine/until_mistakes.hpp"

namespace ljmd {

namespace {

/// What stages of both kinds have.
Stage stage_of(const StageTable& table) {
    return {.name = table.name,
            .integrator = table.integrator,
            .time_step = table.time_step,
            .steps = table.steps,
            .sample = table.sample,
            .reverse = table.reverse};
}

Stage stage_of(const Placed<FluidStageTable>& table, const FluidTables& tables) {
    Stage stage = stage_of(static_cast<const StageTable&>(table));
    if (table.given(&FluidStageTable::thermostat) && table.thermostat->sound(&ThermostatTable::method)) {
        stage.thermostat = table.thermostat->method;
    }
    if (table.given(&FluidStageTable::barostat) && table.barostat->sound(&BarostatTable::method)) {
        stage.barostat = table.barostat->method;
    }
    if (table.sound(&FluidStageTable::total_energy)) {
        stage.total_energy = table.total_energy;
    }
    if (table.given(&FluidStageTable::until)) {
        const Placed<UntilTable>& until = *table.until;
        stage.steps = until.max_steps;
        for (std::size_t k = 0; k < until.errors.size(); ++k) {
            if (until.errors[k]) {
                stage.until.push_back({until_observables()[k].name, *until.errors[k]});
            }
        }
    }
    stage.seed = static_cast<std::uint64_t>(tables.system.seed);
    // That a thermostat lacks its temperature is reported elsewhere: the stand-in breaks no rule.
    stage.temperature = stage_temperature(table, tables).value_or(stage.thermostat ? 1.0 : 0.0);
    return stage;
}

}  // namespace

std::vector<Stage> stages_of(const FluidTables& tables) {
    std::vector<Stage> stages;
    for (const Placed<FluidStageTable>& table : tables.stages) {
        stages.push_back(stage_of(table, tables));
    }
    return stages;
}

std::vector<Stage> stages_of(const FewBodyTables& tables) {
    std::vector<Stage> stages;
    for (const StageTable& table : tables.stages) {
        stages.push_back(stage_of(table));
    }
    return stages;
}

std::optional<double> stage_temperature(const Placed<FluidStageTable>& stage, const FluidTables& tables) {
    if (stage.temperature) {
        return stage.sound(&FluidStageTable::temperature) ? stage.temperature : std::nullopt;
    }
    return tables.system.sound(&SystemTable::temperature) ? tables.system.temperature : std::nullopt;
}

}  // namespace ljmd
