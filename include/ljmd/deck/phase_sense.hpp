#pragma once

#include "ljmd/core/diagnostics.hpp"
#include "ljmd/deck/deck.hpp"

namespace ljmd {

/// Warn where the fluid that a deck samples is beyond its freezing density at the temperature that the deck asks for.
///
/// Known for the full Lennard-Jones potential alone (see freezing_densities()); what a cutoff changes is small beside
/// the gap between fluid and crystal, so the warning is given for every truncation, and says so. Silent where no one
/// density or temperature is asked for: with a barostat, several temperatures, or none.
/// @param density  of the start [sigma^-3]
/// @pre  the deck has no errors
void check_phase(const Deck& deck, double density, Diagnostics& diagnostics);

}  // namespace ljmd
