#include "observables/transport/correlation_windows.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "execution/loops.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

/// Series transformed together: enough to read whole cache lines of each frame.
constexpr Index batch = 16;
/// Batches per block of a parallel loop.
constexpr Index batches_a_block = 16;

}  // namespace

CorrelationWindows::CorrelationWindows(Index series, Index lags, Index window)
    : series_(series),
      lags_(lags),
      window_(window),
      forward_(fast_length(std::max(window + lags, Index{1})), batch),
      backward_(forward_.length()) {
    if (series < 1 || lags < 1 || window <= lags) {
        throw ContractViolation(fmt::format("a window of {} frames of {} series has no {} lags", window, series, lags));
    }
}

std::optional<Eigen::VectorXd> CorrelationWindows::add(const Eigen::VectorXd& frame, const Execution& execution) {
    if (frame.size() != series_) {
        throw ContractViolation(fmt::format("a frame of {} numbers was added to windows of {}", frame.size(), series_));
    }
    frames_.reserve(static_cast<std::size_t>(series_ * window_));
    frames_.insert(frames_.end(), frame.begin(), frame.end());
    if (static_cast<Index>(frames_.size()) < series_ * window_) {
        return std::nullopt;
    }
    const Eigen::VectorXd correlation = correlate(execution);
    frames_.clear();
    return correlation;
}

Eigen::VectorXd CorrelationWindows::correlate(const Execution& execution) const {
    const Index length = forward_.length();
    const Index half = length / 2 + 1;
    const Index batches = (series_ + batch - 1) / batch;
    const auto power_of_block = [&](Index first, Index last) {
        AlignedVector<double> padded(static_cast<std::size_t>(batch * length));
        AlignedVector<std::complex<double>> transformed(static_cast<std::size_t>(batch * half));
        Eigen::VectorXd power = Eigen::VectorXd::Zero(half);
        for (Index b = first; b < last; ++b) {
            const Index begin = b * batch;
            const Index count = std::min(batch, series_ - begin);
            for (Index t = 0; t < window_; ++t) {
                const double* frame = frames_.data() + t * series_ + begin;
                for (Index s = 0; s < count; ++s) {
                    padded[static_cast<std::size_t>(s * length + t)] = frame[s];
                }
            }
            forward_(padded, transformed);
            for (Index s = 0; s < count; ++s) {
                const Eigen::Map<const Eigen::VectorXcd> spectrum(transformed.data() + s * half, half);
                power += spectrum.cwiseAbs2();
            }
        }
        return power;
    };
    const Eigen::VectorXd power =
        join_blocks(execution, batches, batches_a_block, Eigen::VectorXd(Eigen::VectorXd::Zero(half)), power_of_block,
                    [](Eigen::VectorXd& sum, const Eigen::VectorXd& block) { sum += block; });
    AlignedVector<std::complex<double>> spectrum(power.begin(), power.end());
    AlignedVector<double> sums(static_cast<std::size_t>(length));
    backward_(spectrum, sums);
    Eigen::VectorXd correlation(lags_ + 1);
    for (Index k = 0; k <= lags_; ++k) {
        correlation[k] =
            sums[static_cast<std::size_t>(k)] / (static_cast<double>(length) * static_cast<double>(window_ - k));
    }
    return correlation;
}

void CorrelationWindows::archive(Archive& a) {
    a(frames_);
    const auto numbers = static_cast<Index>(frames_.size());
    if (numbers % series_ != 0 || numbers >= series_ * window_) {
        throw CheckpointError(fmt::format("its correlations are not of {} series in windows of {}", series_, window_));
    }
}

Eigen::VectorXd running_integral(const Eigen::VectorXd& values, double spacing) {
    Eigen::VectorXd integral(values.size());
    integral[0] = 0.0;
    for (Index k = 1; k < values.size(); ++k) {
        integral[k] = integral[k - 1] + 0.5 * spacing * (values[k - 1] + values[k]);
    }
    return integral;
}

}  // namespace ljmd
