#include "ljmd/observables/statistics/blocking.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <vector>

#include "ljmd/core/errors.hpp"
#include "ljmd/detail/core/archived_count.hpp"

namespace ljmd {
namespace {

constexpr Index many_blocks = 16;  // with fewer, the scatter of the error (18 %) hides whether the curve is flat
constexpr Index fallback_blocks = 4;
constexpr double few_samples = 16.0;    // independent samples; fewer do not support an error bar
constexpr double growth_of_flat = 1.3;  // of the error at twice the block length; sqrt(2) for short blocks
constexpr Index blocks_for_slow = 32;   // at least, of blocks that may show slow fluctuations
constexpr Index most_parts = 8;         // of a function; sums of more, of shells or layers, are series of their own
constexpr double negligible = 0.1;      // error of a part over the function's: a volume that rounding changes
constexpr double excess = 1.5;          // of their error, in units of its scatter
constexpr double lack = 2.5;            // of it, where shorter blocks show an oscillation
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

using Curve = std::vector<BlockLevel>;

bool blocks_are_long_enough(const BlockLevel& level, double samples, double shortest_error) {
    const double length = static_cast<double>(level.length);
    // Errors below the error of independent samples are mostly scatter of few blocks.
    const double growth = std::max(1.0, level.standard_error / shortest_error);
    return length * length * length > 2.0 * samples * std::pow(growth, 4);
}

/// Whether the error still grows at the longest blocks of which there are many.
bool still_grows(const Curve& curve) {
    const auto few =
        std::find_if(curve.begin(), curve.end(), [](const BlockLevel& level) { return level.blocks < many_blocks; });
    const auto levels = few - curve.begin();
    return levels >= 2 && curve[static_cast<std::size_t>(levels - 1)].standard_error >
                              growth_of_flat * curve[static_cast<std::size_t>(levels - 2)].standard_error;
}

/// By how much the error of longer blocks, made of the same samples, differs from that of shorter ones by chance.
double scatter(const BlockLevel& longer, const BlockLevel& shorter) {
    return std::sqrt(longer.relative_uncertainty * longer.relative_uncertainty -
                     shorter.relative_uncertainty * shorter.relative_uncertainty);
}

/// The level with long enough blocks, or a later one: blocks shorter than a period show an oscillation that cancels in
/// longer ones; see BlockingAccumulator.
Curve::const_iterator without_oscillations(Curve::const_iterator chosen, Curve::const_iterator end) {
    for (auto level = std::next(chosen); level != end && level->blocks >= blocks_for_slow; ++level) {
        if (level->standard_error < (1.0 - lack * scatter(*level, *chosen)) * chosen->standard_error) {
            chosen = level;
        }
    }
    return chosen;
}

/// The level with long enough blocks, or a later one, whose blocks show what its own hide; see BlockingAccumulator.
Curve::const_iterator with_slow_fluctuations(Curve::const_iterator chosen, Curve::const_iterator end) {
    auto largest = chosen;
    for (auto level = std::next(chosen); level != end && level->blocks >= blocks_for_slow; ++level) {
        const bool is_more = level->standard_error > (1.0 + excess * scatter(*level, *chosen)) * chosen->standard_error;
        if (is_more && level->standard_error > largest->standard_error) {
            largest = level;
        }
    }
    return largest;
}

/// @param least  samples: the error of blocks up to this length is not to be larger than the one that is chosen
Estimate choose_level(double mean, Index samples, const Curve& curve, Index least = 1) {
    if (samples < fallback_blocks || !std::isfinite(curve.front().standard_error)) {
        return {mean, nan, nan, samples, false};
    }
    const double n = static_cast<double>(samples);
    const double shortest_error = curve.front().standard_error;
    if (shortest_error == 0.0) {
        return {mean, 0.0, n, samples, true, samples};
    }
    auto long_enough = std::find_if(curve.begin(), curve.end(), [&](const BlockLevel& level) {
        return level.blocks >= many_blocks && blocks_are_long_enough(level, n, shortest_error);
    });
    if (long_enough != curve.end()) {
        long_enough = without_oscillations(long_enough, curve.end());
    }
    const auto few = std::find_if(curve.begin(), curve.end(),
                                  [](const BlockLevel& level) { return level.blocks < fallback_blocks; });
    const auto is_smaller = [](const BlockLevel& a, const BlockLevel& b) {
        return a.standard_error < b.standard_error;
    };
    const auto of_series = long_enough != curve.end() ? with_slow_fluctuations(long_enough, curve.end())
                                                      : std::max_element(curve.begin(), few, is_smaller);
    const auto longer = std::find_if(of_series, few, [=](const BlockLevel& level) { return level.length > least; });
    const auto chosen = longer == of_series ? of_series : std::max_element(of_series, longer, is_smaller);
    const double ratio =
        shortest_error / chosen->standard_error;  // infinite if blocks of an alternating series are equal
    const double independent = n * std::min(1.0, ratio * ratio);
    const bool converged = chosen == long_enough || (independent >= few_samples && !still_grows(curve));
    return {mean, chosen->standard_error, independent, samples, converged, chosen->blocks};
}

}  // namespace

BlockingAccumulator::BlockingAccumulator(Index width, Covariance covariance) : width_(width), covariance_(covariance) {
    if (width < 1) {
        throw InputError(fmt::format("block averages need at least one component, not {}", width));
    }
}

void BlockingAccumulator::add(const Eigen::VectorXd& sample) {
    if (sample.size() != width_) {
        throw InputError(
            fmt::format("a sample of {} components was added to block averages of {}", sample.size(), width_));
    }
    Eigen::VectorXd block = sample;
    for (std::size_t k = 0;; ++k) {
        if (k == levels_.size()) {
            levels_.push_back({0, Eigen::VectorXd::Zero(width_), Eigen::VectorXd::Zero(kept_products()), {}});
        }
        Level& level = levels_[k];
        accumulate(level, block);
        if (level.blocks % 2 == 1) {
            level.pending = block;
            return;
        }
        block = 0.5 * (level.pending + block);
    }
}

void BlockingAccumulator::accumulate(Level& level, const Eigen::VectorXd& block) const {
    level.blocks += 1;
    const double n = static_cast<double>(level.blocks);
    const Eigen::VectorXd step = block - level.mean;
    level.mean += step / n;
    if (covariance_ == Covariance::diagonal) {
        level.deviation += (n - 1.0) / n * step.cwiseAbs2();
        return;
    }
    for (Index column = 0; column < width_; ++column) {
        const Index below = width_ - column;
        level.deviation.segment(diagonal(column), below) += (n - 1.0) / n * step[column] * step.tail(below);
    }
}

Index BlockingAccumulator::products(Index width, Covariance covariance) {
    return covariance == Covariance::full ? width * (width + 1) / 2 : width;
}

double BlockingAccumulator::bytes(Index width, Covariance covariance, Index samples) {
    const auto all = static_cast<std::uint64_t>(std::max<Index>(samples, 0));
    const double numbers = static_cast<double>(width + products(width, covariance));
    // A block waits at each level whose number of blocks is odd: at the binary digits of the number of samples that
    // are 1.
    const auto kept = [&](std::uint64_t n) {
        return static_cast<double>(std::bit_width(n)) * numbers +
               static_cast<double>(std::popcount(n)) * static_cast<double>(width);
    };
    // Most of them do at a number below, which has a digit less and then only ones.
    double most = kept(all);
    for (int digit = 0; digit < static_cast<int>(std::bit_width(all)); ++digit) {
        if (const std::uint64_t one = std::uint64_t{1} << digit; (all & one) != 0) {
            most = std::max(most, kept((all & ~one) | (one - 1)));
        }
    }
    return 8.0 * most;
}

Index BlockingAccumulator::diagonal(Index component) const {
    return covariance_ == Covariance::full ? component * width_ - component * (component - 1) / 2 : component;
}

void BlockingAccumulator::archive(Archive& a) {
    a(levels_);
    // Two blocks of a level make one of the next; the last level has one block.
    Index expected = samples();
    require_count(expected);
    for (const Level& level : levels_) {
        if (level.blocks < 1 || level.blocks != expected) {
            throw CheckpointError("its block averages fit no number of samples");
        }
        expected /= 2;
        if (level.mean.size() != width_ || level.deviation.size() != kept_products() ||
            level.pending.size() != width_) {
            throw CheckpointError(fmt::format("its block averages are not {} wide", width_));
        }
    }
    if (expected != 0) {
        throw CheckpointError("its block averages fit no number of samples");
    }
}

Index BlockingAccumulator::samples() const {
    return levels_.empty() ? 0 : levels_.front().blocks;
}

Eigen::VectorXd BlockingAccumulator::mean() const {
    return mean_of(0, width_);
}

Eigen::VectorXd BlockingAccumulator::mean_of(Index first, Index count) const {
    if (levels_.empty()) {
        return Eigen::VectorXd::Constant(count, nan);
    }
    // Every sample is in exactly one pending block; their lengths are the binary digits of the number of samples.
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(count);
    double length = 1.0;
    for (const Level& level : levels_) {
        if (level.blocks % 2 == 1) {
            sum += length * level.pending.segment(first, count);
        }
        length *= 2.0;
    }
    return sum / static_cast<double>(samples());
}

Eigen::VectorXd BlockingAccumulator::covariances(Index component) const {
    check(component);
    if (covariance_ != Covariance::full) {
        throw InputError("covariances need block averages with Covariance::full");
    }
    Eigen::VectorXd result = Eigen::VectorXd::Constant(width_, nan);
    for (Index other = 0; other < width_ && samples() > 1; ++other) {
        const auto [first, second] = std::minmax(component, other);
        result[other] =
            levels_.front().deviation[diagonal(first) + second - first] / static_cast<double>(samples() - 1);
    }
    return result;
}

template <class Deviation>
std::vector<BlockLevel> BlockingAccumulator::curve(Deviation deviation) const {
    std::vector<BlockLevel> result;
    Index length = 1;
    for (const Level& level : levels_) {
        if (level.blocks < 2) {
            break;
        }
        const double freedom = static_cast<double>(level.blocks - 1);
        const double variance = deviation(level.deviation) / freedom;
        const double share = static_cast<double>(length) / static_cast<double>(samples());
        result.push_back({length, level.blocks, std::sqrt(variance * share), 1.0 / std::sqrt(2.0 * freedom)});
        length *= 2;
    }
    return result;
}

void BlockingAccumulator::check(Index component) const {
    if (component < 0 || component >= width_) {
        throw InputError(fmt::format("component {} was asked of block averages of {}", component, width_));
    }
}

std::vector<BlockLevel> BlockingAccumulator::levels(Index component) const {
    check(component);
    return curve([&](const Eigen::VectorXd& deviation) { return deviation[diagonal(component)]; });
}

Estimate BlockingAccumulator::estimate(Index component) const {
    check(component);
    return choose_level(mean_of(component, 1)[0], samples(), levels(component));
}

Estimate BlockingAccumulator::estimate(double value, const Eigen::VectorXd& gradient,
                                       const std::vector<Index>& more) const {
    if (covariance_ != Covariance::full) {
        throw InputError("the error of a function of means needs block averages with Covariance::full");
    }
    if (gradient.size() != width_) {
        throw InputError(
            fmt::format("a gradient of {} components was given to block averages of {}", gradient.size(), width_));
    }
    // For a combination that does not vary, round-off may give a slightly negative sum; NaN passes through.
    const auto along_gradient = [&](const Eigen::VectorXd& deviation) {
        double sum = 0.0;
        for (Index column = 0; column < width_; ++column) {
            const Index below = width_ - column - 1;
            const double others = deviation.segment(diagonal(column) + 1, below).dot(gradient.tail(below));
            sum += gradient[column] * (gradient[column] * deviation[diagonal(column)] + 2.0 * others);
        }
        return sum < 0.0 ? 0.0 : sum;
    };
    const std::vector<BlockLevel> levels = curve(along_gradient);
    const double alone = choose_level(value, samples(), levels).standard_error;
    Index longest = 1;
    bool converged = true;
    const auto add_part = [&](const Estimate& part) {
        longest = std::max(longest, part.samples / std::max<Index>(part.blocks, 1));
        converged = converged && part.converged;
    };
    // Of many the longest blocks are long by chance.
    const bool of_few = (gradient.array() != 0.0).count() <= most_parts;
    for (Index component = 0; component < width_ && of_few; ++component) {
        if (gradient[component] != 0.0) {
            const Estimate part = estimate(component);
            if (!(std::abs(gradient[component]) * part.standard_error < negligible * alone)) {
                add_part(part);
            }
        }
    }
    for (const Index component : more) {
        add_part(estimate(component));
    }
    Estimate found = choose_level(value, samples(), levels, longest);
    found.converged = found.converged && converged;
    return found;
}

}  // namespace ljmd
