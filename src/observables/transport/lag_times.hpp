#pragma once

#include <optional>
#include <string>

#include "ljmd/detail/observables/analysis.hpp"

namespace ljmd {

/// Time differences at which a time correlation function is measured: 0, h, 2 h, ... count * h.
struct LagTimes {
    Index every;     ///< steps between configurations
    Index count;     ///< at least 1
    double spacing;  ///< h = every * time step [tau]

    [[nodiscard]] double time(Index lag) const { return static_cast<double>(lag) * spacing; }
};

/// Defaults of LagOptions.
struct UsualLags {
    Index every;
    double max_time;  ///< [tau]
    double share;     ///< of a sampled stage, where that is shorter
};

/// The keys `every` and `max_time` of an analysis.
struct LagOptions {
    explicit LagOptions(const UsualLags& usual) : every(usual.every), usual_(usual) {}

    Index every;                          ///< [steps]
    std::optional<double> max_time = {};  ///< [tau]

    void describe(Description& description);

    /// The times that the options give for a run. The largest is rounded down to a multiple of h, but is at least h.
    [[nodiscard]] LagTimes times(const SampledRun& run) const;

    /// Mistakes in the options: a largest time below h, or longer than the longest sampled stage.
    /// @param analysis  its name for messages
    [[nodiscard]] Misfits check(const SampledRun& run, const std::string& analysis) const;

  private:
    UsualLags usual_;
};

/// Number of configurations in a window for correlations at these times: twice as many as the largest time spans, or as
/// many as the longest sampled stage has; always greater than lags.count.
[[nodiscard]] Index correlation_window(const LagTimes& lags, const SampledRun& run);

}  // namespace ljmd
