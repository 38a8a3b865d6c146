#pragma once

#include <optional>
#include <string>

#include "ljmd/detail/core/archive.hpp"
#include "ljmd/detail/model/state.hpp"

namespace ljmd {

/// Closest approach of two bodies.
struct Approach {
    double distance;
    double time;
    Index first;  ///< ids counted from 1, first < second
    Index second;
    double path_in_step;  ///< relative speed times length of the step; 0 without a step

    /// Whether steps resolve the encounter: within one of them the bodies move relative to each other by at most half
    /// their distance. Otherwise a force that grows as they approach is not sampled where it is largest, and neither
    /// this distance nor the motion afterwards is correct. At this limit velocity Verlet has the distance to about 1 %.
    [[nodiscard]] bool resolved() const { return path_in_step <= 0.5 * distance; }

    void archive(Archive& a) { a(distance, time, first, second, path_in_step); }
};

/// Why numbers have no value after an encounter that steps do not resolve.
/// @param who  as in "bodies 1 and 2 meet"
/// @param path  in the step, in units of the distance
[[nodiscard]] std::string unresolved_encounter(const std::string& who, double time, double path);

/// The same for two bodies.
[[nodiscard]] std::string unresolved_encounter(const Approach& approach);

/// Smallest distance between any two bodies of a system without a box, sampled at every step of the integrator.
///
/// It is the minimum over all samples and over the minima within steps. Where r . v of a pair turns from negative to
/// positive, r is interpolated by the cubic Hermite polynomial through both samples. Exact to O(h^4) for exact samples.
/// A sample with |r . v| <= 1e-12 |r||v| is itself such a minimum: many motions begin at one.
class ClosestApproach {
  public:
    /// Add the next sample, at state.time.
    /// @pre the state has no box
    /// @throws ContractViolation unless time increases and the number of bodies stays the same
    void add(const State& state);

    /// Empty without samples and for fewer than two bodies. The earliest of equal distances.
    [[nodiscard]] const std::optional<Approach>& closest() const { return closest_; }

    /// The earliest minimum of a distance, closest or not, that steps do not resolve. Empty if there is none.
    [[nodiscard]] const std::optional<Approach>& first_unresolved() const { return first_unresolved_; }

    /// @param now  state from which sampling continues  @throws CheckpointError for samples of other bodies or later
    ///             times
    void archive(Archive& a, const State& now);

  private:
    struct Sample {
        double time;
        Eigen::Matrix3Xd r;  // columns by id
        Eigen::Matrix3Xd v;

        void archive(Archive& a) { a(time, r, v); }
    };

    void compare(const Approach& candidate);
    void compare_within_step(const Sample& now, Index i, Index j);

    std::optional<Sample> last_;
    std::optional<Approach> closest_;
    std::optional<Approach> first_unresolved_;
};

}  // namespace ljmd
