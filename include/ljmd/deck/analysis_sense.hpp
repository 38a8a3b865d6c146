#pragma once

#include <vector>

#include "ljmd/core/diagnostics.hpp"
#include "ljmd/deck/tables/fluid_tables.hpp"

namespace ljmd {

/// What [analysis] of a fluid's deck asks for. @param analysis  may still have mistakes
[[nodiscard]] std::vector<ChosenAnalysis> chosen_analyses(const FluidAnalysisTable& analysis);

/// Check that the analyses fit the run, its box and its stages. Warn where a thermostat changes the motion that they
/// measure.
/// @param tables  with at least one [[stage]]; they may still have mistakes
/// @param box     at the start
void check_analyses(const Placed<FluidTables>& tables, Index atoms, const Box& box, Diagnostics& diagnostics);

}  // namespace ljmd
