#include "observables/transport/overlapping_origins.hpp"

#include <cmath>

namespace ljmd {

namespace {

// As in BlockingAccumulator.
constexpr double few_samples = 16.0;
constexpr double excess = 1.5;

/// Covariance of the slopes from two origins that are so many frames apart, up to a factor. The double sum is a single
/// one because min(j, k)^2 = sum of 2 i - 1 for i from 1 to min(j, k).
/// @param later  sums of the weights from each frame on
double covariance(const Eigen::VectorXd& later, Index apart) {
    double sum = 0.0;
    for (Index i = 1; i + apart < later.size(); ++i) {
        sum += static_cast<double>(2 * i - 1) * later[i + apart] * later[i];
    }
    return sum;
}

}  // namespace

double independent_origins(const Eigen::VectorXd& weights, Index between, Index origins) {
    Eigen::VectorXd later = weights;
    for (Index k = later.size() - 2; k >= 0; --k) {
        later[k] += later[k + 1];
    }
    const auto n = static_cast<double>(origins);
    const double variance = covariance(later, 0);
    double inefficiency = 1.0;
    for (Index m = 1; m < origins && m * between + 1 < weights.size(); ++m) {
        inefficiency += 2.0 * (1.0 - static_cast<double>(m) / n) * covariance(later, m * between) / variance;
    }
    return n / inefficiency;
}

Estimate overlapping_estimate(const BlockingAccumulator& means, Index component, double independent) {
    const Estimate by_blocks = means.estimate(component);
    if (!std::isfinite(by_blocks.standard_error) || by_blocks.standard_error == 0.0) {
        return by_blocks;
    }
    const double of_single = means.levels(component).front().standard_error;
    const double error = of_single * std::sqrt(static_cast<double>(by_blocks.samples - 1) / (independent - 1.0));
    const double scatter = 1.0 / std::sqrt(2.0 * static_cast<double>(by_blocks.blocks - 1));
    if (by_blocks.standard_error > (1.0 + excess * scatter) * error) {
        return by_blocks;
    }
    Estimate estimate = by_blocks;
    estimate.standard_error = error;
    estimate.independent_samples = independent;
    estimate.converged = independent >= few_samples;
    return estimate;
}

}  // namespace ljmd
