#pragma once

#include <optional>

#include "ljmd/core/archive.hpp"
#include "ljmd/model/state.hpp"

namespace ljmd {

/// How near two bodies came to each other, when, and which.
struct Approach {
    double distance;
    double time;
    Index first;  ///< ids counted from 1, first < second
    Index second;

    void archive(Archive& a) { a(distance, time, first, second); }
};

/// Smallest distance between any two bodies of a system without a box, sampled once a step of the integrator.
///
/// The smallest over all samples and over the minima within steps: where r . v of a pair turns from negative to
/// positive, r is the cubic Hermite polynomial through both samples. Exact to O(h^4) for exact samples.
class ClosestApproach {
  public:
    /// The next sample, at state.time.
    /// @pre the state has no box
    /// @throws ContractViolation unless time increases and the number of bodies stays
    void add(const State& state);

    /// Empty without samples and for fewer than two bodies. Of equal distances the earliest.
    [[nodiscard]] const std::optional<Approach>& closest() const { return closest_; }

    /// @param now  from which samples go on  @throws CheckpointError for samples of other bodies or later times
    void archive(Archive& a, const State& now);

  private:
    struct Sample {
        double time;
        Eigen::Matrix3Xd r;  // column of a body: its id
        Eigen::Matrix3Xd v;

        void archive(Archive& a) { a(time, r, v); }
    };

    void compare(const Approach& candidate);
    void compare_within_step(const Sample& now, Index i, Index j);

    std::optional<Sample> last_;
    std::optional<Approach> closest_;
};

}  // namespace ljmd
