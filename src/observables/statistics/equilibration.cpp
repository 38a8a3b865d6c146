#include "ljmd/observables/statistics/equilibration.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ljmd/core/errors.hpp"
#include "ljmd/observables/fourier.hpp"

namespace ljmd {

namespace {

constexpr Index shortest_sum = 3;  // a C(t) that is negative by chance does not end a shorter sum
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

using Series = Eigen::Map<const Eigen::VectorXd>;

Series view(std::span<const double> series) {
    return {series.data(), static_cast<Index>(series.size())};
}

/// Sums of dx_s dx_(s+t) over s, for each t.
AlignedVector<double> lagged_sums(const Eigen::VectorXd& deviations) {
    const Index length = fast_length(2 * deviations.size());
    AlignedVector<double> padded(static_cast<std::size_t>(length));
    std::copy(deviations.begin(), deviations.end(), padded.begin());
    AlignedVector<std::complex<double>> transformed(static_cast<std::size_t>(length / 2 + 1));
    RealTransform{length}(padded, transformed);
    for (std::complex<double>& value : transformed) {
        value = std::norm(value) / static_cast<double>(length);
    }
    InverseRealTransform{length}(transformed, padded);
    return padded;
}

}  // namespace

double statistical_inefficiency(std::span<const double> series) {
    const auto n = static_cast<Index>(series.size());
    if (n < 2 || !view(series).allFinite()) {
        return not_a_number;
    }
    const Eigen::VectorXd deviations = view(series).array() - view(series).mean();
    const double variance = deviations.squaredNorm() / static_cast<double>(n);
    if (variance == 0.0) {
        return 1.0;
    }
    const AlignedVector<double> sums = lagged_sums(deviations);
    double g = 1.0;
    for (Index t = 1; t < n - 1; ++t) {
        const double c = sums[static_cast<std::size_t>(t)] / (static_cast<double>(n - t) * variance);
        if (c <= 0.0 && t > shortest_sum) {
            break;
        }
        g += 2.0 * c * (1.0 - static_cast<double>(t) / static_cast<double>(n));
    }
    return std::max(g, 1.0);
}

Equilibration detect_equilibration(std::span<const double> series, Index stride) {
    const auto n = static_cast<Index>(series.size());
    if (n < 1 || stride < 1) {
        throw ContractViolation(
            "equilibrium is looked for in a series of at least one sample, in steps of at least one");
    }
    Equilibration best{0, not_a_number, not_a_number, not_a_number, not_a_number};
    for (Index start = 0; start < n - 1; start += stride) {
        const double g = statistical_inefficiency(series.subspan(static_cast<std::size_t>(start)));
        const double independent = static_cast<double>(n - start) / g;
        if (!(independent <= best.independent_samples)) {
            best.start = start;
            best.inefficiency = g;
            best.independent_samples = independent;
        }
    }
    const Series rest = view(series.subspan(static_cast<std::size_t>(best.start)));
    best.mean = rest.mean();
    const double deviation = std::sqrt((rest.array() - best.mean).square().mean());
    best.standard_error = deviation / std::sqrt(best.independent_samples);
    return best;
}

}  // namespace ljmd
