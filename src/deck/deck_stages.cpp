#include "deck/deck_stages.hpp"

namespace ljmd {

std::vector<Stage> stages_of(const FluidTables& tables) {
    std::vector<Stage> stages;
    for (const Placed<Stage>& table : tables.stages) {
        Stage& stage = stages.emplace_back(table);
        if (!table.sound(&Stage::total_energy)) {
            stage.total_energy.reset();
        }
        const bool sound_thermostat = table.all_sound_in(&Stage::thermostat);
        if (!sound_thermostat) {
            stage.thermostat.reset();
        }
        if (!sound_thermostat || !table.all_sound_in(&Stage::barostat)) {
            stage.barostat.reset();  // a rule would miss its thermostat
        }
        stage.seed = static_cast<std::uint64_t>(tables.system.seed);
        stage.temperature = stage_temperature(table, tables);
        if (stage.thermostat && !stage.temperature) {
            stage.temperature = 1.0;  // that there is none is reported elsewhere: the stand-in breaks no rule
        }
    }
    return stages;
}

std::vector<Stage> stages_of(const FewBodyTables& tables) {
    return {tables.stages.begin(), tables.stages.end()};
}

std::optional<double> stage_temperature(const Placed<Stage>& stage, const FluidTables& tables) {
    if (stage.temperature) {
        return stage.sound(&Stage::temperature) ? stage.temperature : std::nullopt;
    }
    return tables.system.sound(&SystemTable::temperature) ? tables.system.temperature : std::nullopt;
}

}  // namespace ljmd
