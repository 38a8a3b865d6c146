#pragma once

#include <optional>
#include <vector>

#include "ljmd/core/types.hpp"

namespace ljmd {

/// Mean of the intervals between successive marks (times of like events, angles of like apsides).
struct IntervalMean {
    double mean;            ///< (last - first) / intervals
    double standard_error;  ///< standard deviation of the intervals / intervals^(1/2); NaN for one interval
    Index intervals;        ///< at least 1
};

/// Empty for fewer than two marks. The error is that of independent intervals. Where the marks themselves are
/// uncertain, neighbouring intervals err in opposite directions, and the mean is better than its error says.
[[nodiscard]] std::optional<IntervalMean> mean_interval(const std::vector<double>& marks);

/// The better known of two means of the same quantity: of two with an error that with the smaller one, otherwise that
/// of more intervals; the second one where they are equal. Two series of like events in one motion are not independent,
/// so their means are not averaged.
[[nodiscard]] std::optional<IntervalMean> better_known(const std::optional<IntervalMean>& first,
                                                       const std::optional<IntervalMean>& second);

}  // namespace ljmd
