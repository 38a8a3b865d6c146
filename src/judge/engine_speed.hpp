#pragma once

#include <functional>
#include <optional>

#include "ljmd/core/types.hpp"

namespace ljmd {

/// How fast an engine runs a deck's stage, beside ljmd. Reported, never judged.
struct EngineSpeed {
    double ours;      ///< [steps/s]
    double theirs;    ///< [steps/s]
    double start_up;  ///< of the engine: what it takes beside its steps, from its start to its end [s]
    Index steps;      ///< of the longer run
};

/// Wall time of a run of this many steps [s].
using SecondsOfRun = std::function<double(Index steps)>;

/// Speeds from two runs each, of a fifth of the steps and of all of them: what they have in common is the start-up (the
/// process, what it reads, compiles and allocates, the first forces) and drops out,
///
///     v = (n_2 - n_1)/(t_2 - t_1),   start-up = t_2 - n_2/v
///
/// Rows of the table are written in both, and count as work. Times are medians of three rounds, in which the two
/// programs take turns.
/// @param every  steps between rows; the shorter run has a multiple of it
/// @return nothing if a longer run did not take longer, so that its speed is not known
/// @pre steps >= 2 every
[[nodiscard]] std::optional<EngineSpeed> compare_speed(const SecondsOfRun& ours, const SecondsOfRun& theirs,
                                                       Index steps, Index every);

}  // namespace ljmd
