#pragma once

#include <span>

#include "ljmd/core/types.hpp"

namespace ljmd {

/// How many samples of a series count as one that is independent of the others:
///
///     g = 1 + 2 sum_{t=1} (1 - t/n) C(t),   C(t) = <dx_0 dx_t>/<dx^2>,   at least 1
///
/// The sum ends before the first t > 3 with C(t) <= 0, where correlations are lost in noise, and before t = n - 1. The
/// correlation time is (g - 1)/2 samples. By a fast Fourier transform, in time O(n log n).
/// @return NaN for fewer than two samples or one that is not finite; 1 for a series that does not vary
/// Source: Chodera, Swope, Pitera, Seok and Dill (2007), doi:10.1021/ct0502864
[[nodiscard]] double statistical_inefficiency(std::span<const double> series);

/// Where a series has come to equilibrium, and what is left of it then.
struct Equilibration {
    Index start;                 ///< samples before it are not used
    double inefficiency;         ///< g of the samples from there on; NaN when it is not known
    double independent_samples;  ///< (n - start)/g
    double mean;                 ///< of the samples from there on
    double standard_error;       ///< their standard deviation times (g/n)^(1/2), n their number
};

/// The start that leaves the most independent samples: what comes before adds more correlation than information.
/// Starts 0, stride, 2 stride, ... are tried, and among equals the first is taken.
/// @param stride  at least 1
/// @throws ContractViolation for a series without samples
/// Source: Chodera (2016), doi:10.1021/acs.jctc.5b00784
[[nodiscard]] Equilibration detect_equilibration(std::span<const double> series, Index stride);

}  // namespace ljmd
