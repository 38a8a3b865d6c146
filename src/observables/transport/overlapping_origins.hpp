#pragma once

#include <Eigen/Core>

#include "ljmd/observables/statistics/blocking.hpp"

namespace ljmd {

/// How many independent values the slopes of the mean-square displacement from overlapping time origins are worth,
///
///     n* = n / (1 + 2 sum over m >= 1 of (1 - m/n) c_m),
///
/// where c_m is the correlation of the slopes D from two origins that are m origins apart. In a random walk the squares
/// of two displacements have the covariance 2 o^2 in units of their steps, where o is the number of steps that they
/// share, so that
///
///     c_m ~ sum over j, k of w_j w_k o^2,   o = max(0, min(j, k + b) - b),   b = m `between`
///
/// with the weights w of D = sum over k of w_k msd_k. Source: normal distribution, cov(x^2, y^2) = 2 cov(x, y)^2
/// @param weights  w at the times 0, 1, 2, ... frames
/// @param between  frames between origins  @param origins  n, at least 1
[[nodiscard]] double independent_origins(const Eigen::VectorXd& weights, Index between, Index origins);

/// Estimate of a series of overlapping samples that are worth a known number n* of independent ones. With the variance
/// v, the mean of the squared deviations,
///
///     e = (v / (n* - 1))^(1/2)
///
/// It scatters half as much as an error by blocks, which have to be longer than the overlap and are few, and it is a
/// guess with fewer than 16 independent samples, as there. Correlations from other causes show in blocks: an error by
/// blocks that is larger by more than 1.5 times its scatter counts in its place, with its own n* and mark.
///
/// Test with random walks of 5 to 30 times the largest time, whose velocity is remembered for 5 % of that: the scatter
/// of D is 1.0 to 1.15 times the error (by blocks 1.0 to 1.4).
[[nodiscard]] Estimate overlapping_estimate(const BlockingAccumulator& means, Index component, double independent);

}  // namespace ljmd
