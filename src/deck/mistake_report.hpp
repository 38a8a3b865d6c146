#pragma once

#include <vector>

#include "deck/tables/few_body_tables.hpp"
#include "deck/tables/fluid_tables.hpp"
#include "engine/mistakes/mistakes.hpp"
#include "ljmd/detail/options/diagnostics.hpp"

namespace ljmd {

/// Report mistakes at their places in a deck. Those that rest on a value which validation has found wrong are left out:
/// its stand-in says nothing about the deck, and each mistake is reported once.
/// @throws ContractViolation for a key that the deck cannot have
void report(const std::vector<Mistake>& mistakes, const Placed<FluidTables>& tables, Diagnostics& diagnostics);
void report(const std::vector<Mistake>& mistakes, const Placed<FewBodyTables>& tables, Diagnostics& diagnostics);

}  // namespace ljmd
