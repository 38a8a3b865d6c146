#pragma once

#include <string>
#include <vector>

#include "core/document.hpp"
#include "deck/fluid.hpp"

namespace ljmd {

/// Estimated cost of a run.
struct Forecast {
    double memory_bytes;  ///< see SizeForecast
    double disk_bytes;
    double seconds;  ///< of the time loop on this machine, extrapolated from a short trial with a stand-in crystal
    int threads;     ///< that compute it in that time
    std::vector<std::string> not_counted = {};  ///< analyses that the stand-in is too small for, or above 1 GB
};

/// Estimate the cost of a run. For each integrator, runs a crystal of about 4000 atoms at most with the deck's density,
/// potential and pair search for about 0.3 seconds, and takes samples of it for each analysis as long, one at least.
/// The deck itself is not run and nothing is written.
[[nodiscard]] Forecast forecast(const Deck& deck, const Start& start, const Execution& execution);

/// The report of `ljmd check` on a fluid. Data: deck, atoms, box_edges, cutoff, largest_cutoff, steps, memory_bytes,
/// disk_bytes, seconds, analyses_not_counted.
[[nodiscard]] Document check_report(const Deck& deck, const Start& start, const Forecast& forecast);

}  // namespace ljmd
