#pragma once

#include "deck/fluid.hpp"

namespace ljmd {

/// Estimated memory and disk space of a run of a fluid, in bytes, within a factor of about 1.3.
struct SizeForecast {
    double memory;  ///< peak resident memory: program, atoms, pair search, analyses, and a checkpoint being written
    double disk;    ///< all files at the end
};

/// Estimate sizes; nothing is run or allocated. Data that analyses keep count twice in memory, for the analysis and for
/// the checkpoint being written; a window of velocities that is empty at each checkpoint takes less.
[[nodiscard]] SizeForecast forecast_size(const Deck& deck, const Start& start);

}  // namespace ljmd
