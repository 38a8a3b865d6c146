#pragma once

#include "ljmd/deck/simulation.hpp"

namespace ljmd {

/// Bytes that a run of a fluid will take, within a factor of about 1.3.
struct SizeForecast {
    double memory;  ///< resident, at the highest: program, atoms, pair search, analyses, a checkpoint that is made
    double disk;    ///< all files at the end
};

/// Nothing is run or allocated. Memory counts what analyses keep twice, as they lie in memory and in the checkpoint
/// that is made: a window of velocities that is empty at each checkpoint takes less.
[[nodiscard]] SizeForecast forecast_size(const Deck& deck, const Start& start);

}  // namespace ljmd
