#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "ljmd/core/types.hpp"

namespace ljmd {

/// Statistical inefficiency of a series: the number of samples that count as one independent sample,
///
///     g = 1 + 2 sum_{t=1} (1 - t/n) C(t),   C(t) = <dx_0 dx_t>/<dx^2>,   at least 1
///
/// The sum ends before the first t > 3 with C(t) <= 0, where noise hides correlations, and before t = n - 1. The
/// correlation time is (g - 1)/2 samples. Computed by a fast Fourier transform, in time O(n log n).
/// @return NaN for fewer than two samples or if one is not finite; 1 for a constant series
/// Source: Chodera, Swope, Pitera, Seok and Dill (2007), doi:10.1021/ct0502864
[[nodiscard]] double statistical_inefficiency(std::span<const double> series);

/// A series of a run.
struct EquilibratingColumn {
    std::vector<double> series;
    /// Of a sample in equilibrium over its mean, at most: (2/f)^(1/2) of the temperature of f degrees of freedom.
    double largest_relative_deviation = std::numeric_limits<double>::infinity();
    bool judged = true;  ///< false: it only tells how slow the run is, as a sum of other columns does best
};

/// Where a run comes to equilibrium.
struct Equilibration {
    /// Samples before it are not in equilibrium; in the first half. Empty where the column still changes in the second
    /// half, and where it is too short to tell.
    std::optional<Index> start;
    bool changes;         ///< it still changes in the second half
    double inefficiency;  ///< samples that count as one independent sample, in the slowest column; NaN if unknown
};

/// Find where a run comes to equilibrium. The second half of its columns is the reference. Pieces of the first half, of
/// 1, 2, 4, ... samples, up to 16 of each length from the start on, have their means compared with the second half's,
/// and the means of its own halves are compared with each other. Two means differ if they lie
///
///     |m_1 - m_2| > (7 + 100/n*) (v (s_1 + s_2))^(1/2),   s_i = min(1, g/n_i),   n* = n/g
///
/// apart, where v is the variance of the second half (with n* - 2 degrees of freedom), n the number of its samples, and
/// g the largest inefficiency of all columns there, by statistical_inefficiency() or by block averages. Or if they lie
/// (8 + 250/n*) such errors apart, of v and g about the line that fits the second half best, which a drift does not
/// enlarge. Neither with n* < 8. Or if they lie 7 times 2^(1/2) of the largest deviation apart, if it is known.
///
/// The end of the last piece that differs, and that goes on as long as the next one differs by 0.4 of the limit, is the
/// start of all columns. If none does and n* < 8, the columns are too short to tell.
///
/// A rule that looks for the start that leaves most independent samples (Chodera 2016, doi:10.1021/acs.jctc.5b00784)
/// takes chance for a change where correlations are slow: in short pieces near the end their inefficiency is
/// underestimated.
/// @param columns  equally long
/// @return for each column; without start and with NaN for columns with fewer than 8 samples or one that is not finite
[[nodiscard]] std::vector<Equilibration> detect_equilibration(const std::vector<EquilibratingColumn>& columns);

}  // namespace ljmd
