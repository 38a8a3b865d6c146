#pragma once

#include <optional>
#include <vector>

#include "ljmd/core/types.hpp"

namespace ljmd {

/// Mean interval between successive marks (times of events of one kind, angles of apsides of one kind).
struct IntervalMean {
    double mean;            ///< (last - first) / intervals
    double standard_error;  ///< standard deviation of the intervals / intervals^(1/2); NaN for one interval
    Index intervals;        ///< at least 1
};

/// Empty for fewer than two marks. The error is for independent intervals. If the marks themselves are uncertain,
/// neighbouring intervals have opposite errors, and the mean is better known than its error says.
[[nodiscard]] std::optional<IntervalMean> mean_interval(const std::vector<double>& marks);

/// The better known of two means of the same quantity: the one with the smaller error, or, unless both have an error,
/// the one with more intervals; the second one if they are equal. Means are not averaged, because two series of events
/// in one motion are not independent.
[[nodiscard]] std::optional<IntervalMean> better_known(const std::optional<IntervalMean>& first,
                                                       const std::optional<IntervalMean>& second);

}  // namespace ljmd
