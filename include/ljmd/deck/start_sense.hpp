#pragma once

#include "ljmd/core/diagnostics.hpp"
#include "ljmd/core/section.hpp"
#include "ljmd/deck/simulation.hpp"

namespace ljmd {

/// Warn of keys in [system] that have no effect on the run, given the start: `temperature` where the velocities are
/// kept or every stage has a temperature of its own, `seed` where nothing is random.
/// @param keeps_velocities  those of the file that the run starts from
/// @pre  the deck has no errors
void check_start_effects(const Section& root, bool keeps_velocities, Diagnostics& diagnostics);

/// What can be said of a deck that starts from a file only when the file is known: cutoff and analyses against the box,
/// keys that have no effect, and a density beyond freezing.
/// @param start  of that deck
void check_start(const Deck& deck, const Start& start, Diagnostics& diagnostics);

}  // namespace ljmd
