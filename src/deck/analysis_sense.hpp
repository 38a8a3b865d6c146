#pragma once

#include "deck/tables/fluid_tables.hpp"
#include "ljmd/detail/options/diagnostics.hpp"

namespace ljmd {

/// Check that the analyses fit the run, its box and its stages. Warn where a thermostat changes the motion that they
/// measure.
/// @param tables  with at least one [[stage]]; they may still have mistakes
/// @param box     at the start
void check_analyses(const Placed<FluidTables>& tables, Index atoms, const Box& box, Diagnostics& diagnostics);

}  // namespace ljmd
