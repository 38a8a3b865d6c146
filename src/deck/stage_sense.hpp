#pragma once

#include "deck/tables/fluid_tables.hpp"
#include "ljmd/detail/options/diagnostics.hpp"

namespace ljmd {

/// Check the stages of a fluid: their names, lengths, integrators and baths. Warn of those that are sampled under a
/// thermostat that samples no ensemble.
/// @param tables  the deck, which may still have mistakes
void check_fluid_stages(const Placed<FluidTables>& tables, Diagnostics& diagnostics);

}  // namespace ljmd
