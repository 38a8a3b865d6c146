#pragma once

#include <string>

#include "ljmd/deck/simulation.hpp"

namespace ljmd {

/// What a run will need.
struct Forecast {
    double memory_bytes;  ///< see SizeForecast
    double disk_bytes;
    double seconds;  ///< of the time loop, on this machine, from a short trial on a stand-in crystal
};

/// Estimate the cost of a run. Integrates a crystal of at most a few thousand atoms at the deck's density, potential
/// and pair search for about a third of a second; the deck itself is not run and nothing is written.
[[nodiscard]] Forecast forecast(const Deck& deck, const Start& start);

/// The report of `ljmd check`.
[[nodiscard]] std::string check_report(const Deck& deck, const Start& start, const Forecast& forecast);

}  // namespace ljmd
