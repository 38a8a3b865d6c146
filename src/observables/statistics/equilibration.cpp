#include "observables/statistics/equilibration.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numbers>

#include "ljmd/observables/statistics/blocking.hpp"
#include "observables/fourier.hpp"

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

/// Scatter of the second half of a series.
struct Scatter {
    double variance = 0.0;
    double inefficiency = 1.0;  ///< samples that count as one independent sample
};

/// Means differ if they lie `errors + few/n*` errors apart, with n* the number of independent samples in the second
/// half: the fewer there are, the less their scatter is known.
struct Criterion {
    double errors;
    double few;
};

/// About the mean, and about a line: a drift makes the scatter about the mean large, and would hide itself.
constexpr std::array<Criterion, 2> criteria{{{7.0, 100.0}, {8.0, 250.0}}};
using Scatters = std::array<Scatter, criteria.size()>;

constexpr Index fewest_samples = 8;         // of a series, so that blocks of its second half have an error
constexpr double fewest_independent = 8.0;  // in the second half, to say that something changes, or that nothing does
constexpr Index pieces_of_a_length = 16;
constexpr double loosely = 0.4;  // of the limit: where a change that was found ends

struct SecondHalf {
    Index samples = 0;
    double mean = not_a_number;
    Scatters scatters;
    double largest_deviation = std::numeric_limits<double>::infinity();  ///< in equilibrium, of a sample
    bool known = false;  ///< there are enough samples, and they are finite
};

/// The larger one of what correlations and block averages tell: both are short of slow fluctuations below fast ones.
Scatter scatter(const Eigen::VectorXd& deviations) {
    BlockingAccumulator blocks(1, Covariance::diagonal);
    for (const double value : deviations) {
        blocks.add(Eigen::VectorXd::Constant(1, value));
    }
    const auto n = static_cast<double>(deviations.size());
    const double by_correlations =
        statistical_inefficiency({deviations.data(), static_cast<std::size_t>(deviations.size())});
    return {deviations.squaredNorm() / n, std::max(by_correlations, n / blocks.estimate(0).independent_samples)};
}

SecondHalf second_half(const EquilibratingColumn& column) {
    const Series whole = view(column.series);
    SecondHalf half;
    half.samples = whole.size() - whole.size() / 2;
    if (whole.size() < fewest_samples || !whole.allFinite()) {
        return half;
    }
    half.known = true;
    half.mean = whole.tail(half.samples).mean();
    const Eigen::VectorXd about_mean = whole.tail(half.samples).array() - half.mean;
    const Eigen::VectorXd line = Eigen::VectorXd::LinSpaced(half.samples, -1.0, 1.0);
    const Eigen::VectorXd about_line = about_mean - line.dot(about_mean) / line.squaredNorm() * line;
    half.scatters = {scatter(about_mean), scatter(about_line)};
    half.largest_deviation = std::abs(half.mean) * column.largest_relative_deviation;
    return half;
}

/// Whether the means of two pieces of so many samples differ. @param part  of the limit
bool differ(const SecondHalf& half, double distance, Index first, Index second, double part = 1.0) {
    for (std::size_t k = 0; k < criteria.size(); ++k) {
        const auto [variance, inefficiency] = half.scatters[k];
        const double independent = static_cast<double>(half.samples) / inefficiency;
        if (independent < fewest_independent) {
            continue;
        }
        // What mean and line take from the scatter of few independent samples is given back.
        const double true_variance = variance / std::max(1.0 - 2.0 / independent, 0.1);
        const auto share = [g = inefficiency](Index samples) {
            return std::min(1.0, g / static_cast<double>(samples));
        };
        const double error = std::sqrt(true_variance * (share(first) + share(second)));
        if (std::abs(distance) > part * (criteria[k].errors + criteria[k].few / independent) * error) {
            return true;
        }
    }
    // However slow it is, a mean scatters no more than a sample.
    return std::abs(distance) > part * criteria.front().errors * std::numbers::sqrt2 * half.largest_deviation;
}

/// The end of the last piece of the first half that differs from the second half; 0 if none does.
Index end_of_change(const std::vector<double>& series, const SecondHalf& half) {
    const auto n = static_cast<Index>(series.size());
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(n / 2 + 1);  // of the deviations before a sample
    for (Index k = 0; k < n / 2; ++k) {
        sums[k + 1] = sums[k] + (series[static_cast<std::size_t>(k)] - half.mean);
    }
    const auto differs = [&](Index begin, Index end, double part) {
        const double distance = (sums[end] - sums[begin]) / static_cast<double>(end - begin);
        return differ(half, distance, end - begin, half.samples, part);
    };
    Index start = 0;
    // Short pieces first: they tell best where a change ends. Long ones show a small change that lasts.
    for (auto parts = static_cast<Index>(std::bit_floor(static_cast<std::uint64_t>(n))); parts >= 4; parts /= 2) {
        for (Index k = 0; k < std::min(parts / 2, pieces_of_a_length); ++k) {
            const Index begin = k * n / parts;
            const Index end = (k + 1) * n / parts;
            if (begin >= start && differs(begin, end, 1.0)) {
                start = end;
            }
        }
    }
    // Less of a change is needed to go on than to begin.
    for (Index length = 1; start > 0 && length <= n / 4; length *= 2) {
        while (start < n / 2 && differs(start, std::min(start + length, n / 2), loosely)) {
            start = std::min(start + length, n / 2);
        }
    }
    return start;
}

/// Whether the halves of the second half differ.
bool still_changes(const std::vector<double>& series, const SecondHalf& half) {
    const Series whole = view(series);
    const Index middle = half.samples / 2;
    const double distance = whole.tail(half.samples).head(middle).mean() - whole.tail(half.samples - middle).mean();
    return differ(half, distance, middle, half.samples - middle);
}

Equilibration equilibration(const EquilibratingColumn& column, const SecondHalf& half) {
    const std::vector<double>& series = column.series;
    if (!half.known) {
        return {std::nullopt, false, not_a_number};
    }
    const double inefficiency = half.scatters.front().inefficiency;
    if (half.scatters.front().variance == 0.0) {  // what it has in the first half may be chance
        const bool is_constant = view(series).maxCoeff() == view(series).minCoeff();
        return {is_constant ? std::optional<Index>(0) : std::nullopt, false, inefficiency};
    }
    const Index start = column.judged ? end_of_change(series, half) : 0;
    const auto n = static_cast<Index>(series.size());
    if (start > n / 2 - n / 16 ||
        (column.judged && still_changes(series, half))) {  // just before the middle no piece tells more
        return {std::nullopt, true, inefficiency};
    }
    const bool too_short = static_cast<double>(half.samples) / inefficiency < fewest_independent;
    return {start == 0 && too_short ? std::nullopt : std::optional(start), false, inefficiency};
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

std::vector<Equilibration> detect_equilibration(const std::vector<EquilibratingColumn>& columns) {
    std::vector<SecondHalf> halves;
    std::ranges::transform(columns, std::back_inserter(halves), second_half);
    // What is slow in one column may be hidden in the others: all are taken to be as slow as the slowest.
    Scatters slowest;
    for (const SecondHalf& half : halves) {
        for (std::size_t k = 0; k < criteria.size(); ++k) {
            slowest[k].inefficiency = std::max(slowest[k].inefficiency, half.scatters[k].inefficiency);
        }
    }
    std::vector<Equilibration> found;
    Index latest = 0;
    for (std::size_t c = 0; c < columns.size(); ++c) {
        for (std::size_t k = 0; k < criteria.size(); ++k) {
            halves[c].scatters[k].inefficiency = slowest[k].inefficiency;
        }
        found.push_back(equilibration(columns[c], halves[c]));
        latest = std::max(latest, found.back().start.value_or(0));
    }
    for (Equilibration& one : found) {
        if (latest > 0 && !one.changes && std::isfinite(one.inefficiency)) {
            one.start = latest;
        }
    }
    return found;
}

}  // namespace ljmd
