#pragma once

#include <optional>
#include <vector>

#include "ljmd/detail/core/archive.hpp"
#include "observables/few_body/sign_changes.hpp"
#include "observables/statistics/interval_mean.hpp"

namespace ljmd {

enum class Direction { upward, downward };

/// Passage of a coordinate through zero.
struct ZeroCrossing {
    Direction direction;
    double time;

    void archive(Archive& a) { a(direction, time); }
};

/// Zero crossings of a coordinate (the angle of a pendulum) and its largest excursion, from samples of its value and
/// rate. Within a step the coordinate is the cubic Hermite polynomial through both samples; for exact samples, times
/// and amplitude are exact to O(h^4). A sample that is exactly zero is a crossing if the signs before and after it
/// differ, or if the series begins with it. Steps must resolve the motion: two crossings within a step are not seen.
class ZeroCrossings {
  public:
    /// Add the next sample. @throws ContractViolation unless time increases
    void add(double time, double x, double rate);

    /// All crossings so far, in order of time. A crossing exactly at a sample is reported with the next sample.
    [[nodiscard]] const std::vector<ZeroCrossing>& crossings() const { return crossings_; }

    /// Mean time between successive crossings in one direction: the direction whose mean is better known
    /// (better_known()). Empty if neither direction has two crossings.
    [[nodiscard]] std::optional<IntervalMean> period() const;

    /// Largest |x| so far, including extremes within steps; 0 without samples.
    [[nodiscard]] double amplitude() const { return amplitude_; }

    /// @param now  time from which sampling continues  @throws CheckpointError for samples of later times
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
