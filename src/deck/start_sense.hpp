#pragma once

#include "deck/fluid.hpp"
#include "ljmd/detail/options/diagnostics.hpp"

namespace ljmd {

/// Warn of keys in [system] that have no effect, given the start. `temperature`: no thermostat uses it, and the
/// velocities are kept, or are drawn at a temperature that no thermostat holds. `seed`: nothing is random.
/// @param keeps_velocities  whether the start file's are kept
/// @pre  the deck has no errors
void check_start_effects(const FluidTables& tables, bool keeps_velocities, Diagnostics& diagnostics);

/// Checks of a deck that need its start: cutoff and analyses against the box, keys without effect, and a density beyond
/// freezing. They are separate for a deck that starts from a file.
/// @param start  of that deck
void check_start(const Deck& deck, const Start& start, Diagnostics& diagnostics);

}  // namespace ljmd
