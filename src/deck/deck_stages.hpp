#pragma once

#include <optional>
#include <vector>

#include "deck/tables/few_body_tables.hpp"
#include "deck/tables/fluid_tables.hpp"
#include "ljmd/engine/stage.hpp"

namespace ljmd {

/// The stages of a deck, which may still have mistakes: a value that validation has found wrong is a stand-in, and a
/// thermostat or barostat with a wrong value is left out, and a barostat beside such a thermostat.
[[nodiscard]] std::vector<Stage> stages_of(const FluidTables& tables);
[[nodiscard]] std::vector<Stage> stages_of(const FewBodyTables& tables);

/// Target temperature of a stage's thermostat [epsilon/k_B]: `temperature` of the stage, else of the system; nothing if
/// neither has a valid one.
[[nodiscard]] std::optional<double> stage_temperature(const Placed<Stage>& stage, const FluidTables& tables);

}  // namespace ljmd
