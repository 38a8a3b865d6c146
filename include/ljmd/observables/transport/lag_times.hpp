#pragma once

#include <string>
#include <utility>
#include <vector>

#include "ljmd/observables/analysis.hpp"

namespace ljmd {

/// Time differences at which a time correlation function is measured: 0, h, 2 h, ... count * h.
struct LagTimes {
    Index every;     ///< steps between configurations
    Index count;     ///< at least 1
    double spacing;  ///< h = every * time step [tau]

    [[nodiscard]] double time(Index lag) const { return static_cast<double>(lag) * spacing; }
};

/// Defaults of the keys `every` and `max_time` of an analysis: steps; and a time [tau], or a fraction of a sampled
/// stage if that is shorter.
struct UsualLags {
    Index every;
    double max_time;
    double share;
};
[[nodiscard]] std::vector<Key> lag_keys(const UsualLags& usual);

/// The times that the options give for a run. The largest time is rounded down to a multiple of h, but is at least h.
[[nodiscard]] LagTimes lag_times(const Section& section, const SampledRun& run, const UsualLags& usual);

/// Number of configurations in a window for correlations at these times: twice as many as the largest time spans, or as
/// many as the longest sampled stage has; always greater than lags.count.
[[nodiscard]] Index correlation_window(const LagTimes& lags, const SampledRun& run);

/// Mistakes in the options: a largest time below h, or longer than the longest sampled stage.
/// @param analysis  its name for messages
[[nodiscard]] std::vector<std::pair<std::string, std::string>> lag_mistakes(const Section& section,
                                                                            const SampledRun& run,
                                                                            const UsualLags& usual,
                                                                            const std::string& analysis);

}  // namespace ljmd
