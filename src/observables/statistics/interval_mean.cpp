#include "observables/statistics/interval_mean.hpp"

#include <cmath>

namespace ljmd {

std::optional<IntervalMean> mean_interval(const std::vector<double>& marks) {
    if (marks.size() < 2) {
        return std::nullopt;
    }
    const double n = static_cast<double>(marks.size() - 1);
    const double mean = (marks.back() - marks.front()) / n;
    double deviation = 0.0;
    for (std::size_t i = 1; i < marks.size(); ++i) {
        const double difference = marks[i] - marks[i - 1] - mean;
        deviation += difference * difference;
    }
    // A single interval has no scatter: 0/0 gives the NaN.
    return IntervalMean{mean, std::sqrt(deviation / (n - 1.0) / n), static_cast<Index>(marks.size() - 1)};
}

std::optional<IntervalMean> better_known(const std::optional<IntervalMean>& first,
                                         const std::optional<IntervalMean>& second) {
    if (!first || !second) {
        return first ? first : second;
    }
    const bool both_have_errors = first->intervals > 1 && second->intervals > 1;
    const bool first_is_better =
        both_have_errors ? first->standard_error < second->standard_error : first->intervals > second->intervals;
    return first_is_better ? first : second;
}

}  // namespace ljmd
