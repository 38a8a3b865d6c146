#pragma once

#include "deck/deck.hpp"
#include "ljmd/detail/options/diagnostics.hpp"

namespace ljmd {

/// Warn if a deck samples the fluid beyond its freezing density at the temperature that the deck requests.
///
/// The freezing density is known only for the full Lennard-Jones potential (see freezing_densities()). The effect of a
/// cutoff is small compared with the gap between fluid and crystal, so the warning is given for every truncation, and
/// names the potential. No warning is given without a single density and temperature: with a barostat, several
/// temperatures, or none.
/// @param density  of the start [sigma^-3]
/// @pre  the deck has no errors
void check_phase(const Deck& deck, double density, Diagnostics& diagnostics);

}  // namespace ljmd
