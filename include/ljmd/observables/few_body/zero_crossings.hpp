#pragma once

#include <optional>
#include <vector>

#include "ljmd/core/archive.hpp"
#include "ljmd/observables/few_body/sign_changes.hpp"
#include "ljmd/observables/statistics/interval_mean.hpp"

namespace ljmd {

enum class Direction { upward, downward };

/// One passage of a coordinate through zero.
struct ZeroCrossing {
    Direction direction;
    double time;

    void archive(Archive& a) { a(direction, time); }
};

/// Passages of a coordinate (the angle of a pendulum) through zero and its largest excursion, from samples of its value
/// and rate. Within a step the coordinate is the cubic Hermite polynomial through both samples: for exact samples times
/// and amplitude are exact to O(h^4). A sample that is exactly zero is a crossing when the signs before and after it
/// differ, or when the series begins with it. Steps must resolve the motion: two crossings within a step are not seen.
class ZeroCrossings {
  public:
    /// The next sample. @throws ContractViolation unless time increases
    void add(double time, double x, double rate);

    /// All crossings so far, in time. One exactly at a sample is told with the next sample.
    [[nodiscard]] const std::vector<ZeroCrossing>& crossings() const { return crossings_; }

    /// Mean time between successive like crossings, of the direction whose mean is the better known (better_known()).
    /// Empty when there are fewer than two crossings of either direction.
    [[nodiscard]] std::optional<IntervalMean> period() const;

    /// Largest |x| so far, extremes within the steps included; 0 without samples.
    [[nodiscard]] double amplitude() const { return amplitude_; }

    /// @param now  from which samples go on  @throws CheckpointError for samples of later times
    void archive(Archive& a, double now);

  private:
    struct Sample {
        double time;
        double x;
        double rate;

        void archive(Archive& a) { a(time, x, rate); }
    };

    std::optional<Sample> last_;
    SignChanges changes_;
    std::vector<ZeroCrossing> crossings_;
    double amplitude_ = 0.0;
};

}  // namespace ljmd
