#pragma once

#include <string>
#include <utility>
#include <vector>

#include "ljmd/observables/analysis.hpp"

namespace ljmd {

/// The times apart at which a time correlation function is measured: 0, h, 2 h, ... count * h.
struct LagTimes {
    Index every;     ///< steps between configurations
    Index count;     ///< at least 1
    double spacing;  ///< h = every * time step [tau]

    [[nodiscard]] double time(Index lag) const { return static_cast<double>(lag) * spacing; }
};

/// The keys `every` and `max_time` of an analysis.
/// @param usual  defaults: steps, and time [tau], or that share of a sampled stage where it is shorter
struct UsualLags {
    Index every;
    double max_time;
    double share;
};
[[nodiscard]] std::vector<Key> lag_keys(const UsualLags& usual);

/// What the keys say for a run. The largest time is rounded down to a multiple of h, but never below h.
[[nodiscard]] LagTimes lag_times(const Section& section, const SampledRun& run, const UsualLags& usual);

/// Configurations in a window over which correlations at these times are averaged: twice as many as the largest one
/// spans, or what the longest sampled stage holds; always more than lags.count.
[[nodiscard]] Index correlation_window(const LagTimes& lags, const SampledRun& run);

/// What is wrong with them: a largest time below h, or one that is more than the longest sampled stage lasts.
/// @param analysis  for the message
[[nodiscard]] std::vector<std::pair<std::string, std::string>> lag_mistakes(const Section& section,
                                                                            const SampledRun& run,
                                                                            const UsualLags& usual,
                                                                            const std::string& analysis);

}  // namespace ljmd
