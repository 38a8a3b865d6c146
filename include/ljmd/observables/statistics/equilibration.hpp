#pragma once

#include <span>

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

/// Start of equilibrium in a series, and statistics of the rest.
struct Equilibration {
    Index start;                 ///< samples before it are discarded
    double inefficiency;         ///< g of the remaining samples; NaN if unknown
    double independent_samples;  ///< (n - start)/g
    double mean;                 ///< mean of the remaining samples
    double standard_error;       ///< standard deviation of the remaining samples times (g/n)^(1/2), n their number
};

/// The start that leaves the most independent samples; earlier samples add more correlation than information. Starts 0,
/// stride, 2 stride, ... are tried; the first of equally good ones is taken.
/// @param stride  at least 1
/// @throws ContractViolation for a series without samples, or if stride < 1
/// Source: Chodera (2016), doi:10.1021/acs.jctc.5b00784
[[nodiscard]] Equilibration detect_equilibration(std::span<const double> series, Index stride);

}  // namespace ljmd
