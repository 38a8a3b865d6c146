#pragma once

#include "deck/tables/few_body_tables.hpp"
#include "deck/tables/fluid_tables.hpp"
#include "ljmd/detail/options/diagnostics.hpp"

namespace ljmd {

/// Warn of settings in a fluid's deck that have no effect: unused keys, stages and analyses that measure nothing,
/// thermostats that never act. Effects that depend on the start are left to check_start_effects().
/// @pre  the deck has no errors
void check_effects(const FluidTables& tables, Diagnostics& diagnostics);

/// The same for a few-body deck. @pre  the deck has no errors
void check_few_body_effects(const FewBodyTables& tables, Diagnostics& diagnostics);

}  // namespace ljmd
