#include "ljmd/detail/observables/statistics/wanted_errors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ljmd {

namespace {

constexpr double enlargement = 2.0;  // times 1/nu
constexpr Index fewest_blocks = 4;   // of an error, see BlockingAccumulator

}  // namespace

Estimate stopped_estimate(Estimate estimate) {
    const double nu = static_cast<double>(std::max(estimate.blocks, fewest_blocks) - 1);
    const double factor = 1.0 + enlargement / nu;
    estimate.standard_error *= factor;
    if (estimate.standard_error > 0.0) {  // a constant series has as many independent samples as samples
        estimate.independent_samples /= factor * factor;
    }
    return estimate;
}

bool is_reached(const Estimate& estimate, double wanted) {
    return estimate.converged && estimate.standard_error <= wanted &&
           estimate.independent_samples >= least_independent_samples;
}

bool is_look(Index samples) {
    Index even = first_look;  // every second look
    while (even <= samples / 2) {
        even *= 2;
    }
    return samples == even ||
           (samples >= first_look &&
            samples == static_cast<Index>(std::ceil(static_cast<double>(even) * std::numbers::sqrt2)));
}

}  // namespace ljmd
