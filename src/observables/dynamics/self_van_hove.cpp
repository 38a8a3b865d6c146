#include "observables/dynamics/self_van_hove.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "execution/loops.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/core/archived_count.hpp"
#include "observables/transport/centre_frame.hpp"
#include "observables/transport/time_origins.hpp"

namespace ljmd {

SelfVanHove::SelfVanHove(Index atoms, const LagTimes& lags, Index origins, const DisplacementBins& bins)
    : atoms_(atoms),
      lags_(lags),
      every_(lags.every),
      frames_between_origins_(frames_between_origins(lags, origins)),
      bins_(bins),
      moments_(static_cast<std::size_t>(lags.count), BlockingAccumulator(2, Covariance::full)),
      histograms_(bins.bins * bins.times, Covariance::diagonal) {
    if (!(bins.radius > 0.0) || bins.times > lags.count) {
        throw ContractViolation(
            fmt::format("no displacements up to {} at {} of {} times", bins.radius, bins.times, lags.count));
    }
}

Index SelfVanHove::lag_of(Index time) const {
    return (time + 1) * lags_.count / bins_.times;
}

void SelfVanHove::sample(const State& state, const Evaluation& /*evaluation*/) {
    ++samples_;
    const Eigen::Matrix3Xd positions = positions_about_centre(state);
    // Origins are independent of each other, so that the bits do not depend on the number of threads.
    for_each_index(state.execution(), static_cast<Index>(origins_.size()),
                   [&](Index k) { add_to(origins_[static_cast<std::size_t>(k)], positions); });
    if (frames_ % frames_between_origins_ == 0) {
        origins_.push_back({positions, Eigen::Matrix2Xd(2, 0), Eigen::MatrixXd(bins_.bins, 0)});
    }
    ++frames_;
    if (origins_.front().moments.cols() < lags_.count) {
        return;
    }
    const Origin& whole = origins_.front();
    for (Index lag = 0; lag < lags_.count; ++lag) {
        moments_[static_cast<std::size_t>(lag)].add(whole.moments.col(lag));
    }
    histograms_.add(Eigen::VectorXd(whole.histogram.reshaped()) / static_cast<double>(atoms_));
    origins_.erase(origins_.begin());
}

void SelfVanHove::add_to(Origin& origin, const Eigen::Matrix3Xd& positions) const {
    const Index lag = origin.moments.cols() + 1;
    const bool is_counted = origin.histogram.cols() < bins_.times && lag == lag_of(origin.histogram.cols());
    Eigen::VectorXd counts = Eigen::VectorXd::Zero(is_counted ? bins_.bins : 0);
    const double per_length = static_cast<double>(bins_.bins) / bins_.radius;
    double squares = 0.0;
    double fourths = 0.0;
    for (Index i = 0; i < atoms_; ++i) {
        const double x = positions(0, i) - origin.positions(0, i);
        const double y = positions(1, i) - origin.positions(1, i);
        const double z = positions(2, i) - origin.positions(2, i);
        const double r2 = x * x + y * y + z * z;
        squares += r2;
        fourths += r2 * r2;
        if (is_counted) {
            const double place = std::sqrt(r2) * per_length;
            if (place < static_cast<double>(bins_.bins)) {
                counts[static_cast<Index>(place)] += 1.0;
            }
        }
    }
    origin.moments.conservativeResize(Eigen::NoChange, lag);
    origin.moments.col(lag - 1) = Eigen::Vector2d(squares, fourths) / static_cast<double>(atoms_);
    if (is_counted) {
        origin.histogram.conservativeResize(Eigen::NoChange, origin.histogram.cols() + 1);
        origin.histogram.rightCols(1) = counts;
    }
}

void SelfVanHove::interrupt() {
    origins_.clear();
    frames_ = 0;
}

std::vector<DataTable> SelfVanHove::tables() const {
    if (histograms_.samples() == 0) {
        return {};
    }
    DataTable alpha{"alpha2", {"time", "alpha_2", "alpha_2_standard_error"}, {}};
    for (Index lag = 0; lag < lags_.count; ++lag) {
        const BlockingAccumulator& moments = moments_[static_cast<std::size_t>(lag)];
        const Eigen::VectorXd mean = moments.mean();
        const double ratio = 0.6 * mean[1] / (mean[0] * mean[0]);
        const Eigen::Vector2d gradient(-2.0 * ratio / mean[0], 0.6 / (mean[0] * mean[0]));
        const Estimate found = moments.estimate(ratio - 1.0, gradient);
        alpha.rows.push_back({lags_.time(lag + 1), found.mean, found.standard_error});
    }
    DataTable gs{"gs", {"time", "r", "G_s", "G_s_standard_error"}, {}};
    const double width = bins_.radius / static_cast<double>(bins_.bins);
    for (Index time = 0; time < bins_.times; ++time) {
        for (Index bin = 0; bin < bins_.bins; ++bin) {
            const Estimate part = histograms_.estimate(time * bins_.bins + bin);
            const auto inner = static_cast<double>(bin);
            // The volume of the shell, (4 pi/3)((n + 1)^3 - n^3) width^3.
            const double volume =
                4.0 / 3.0 * std::numbers::pi * (3.0 * inner * (inner + 1.0) + 1.0) * width * width * width;
            gs.rows.push_back(
                {lags_.time(lag_of(time)), (inner + 0.5) * width, part.mean / volume, part.standard_error / volume});
        }
    }
    return {alpha, gs};
}

void SelfVanHove::archive(Archive& a) {
    a(samples_, frames_, origins_, histograms_);
    for (BlockingAccumulator& moments : moments_) {
        a(moments);
    }
    require_count(samples_);
    require_count(frames_);
    // One of age a has a - 1 displacements.
    require_origins(
        origins_, frames_, frames_between_origins_, lags_.count,
        [&](const Origin& origin, Index age) {
            Index counted = 0;
            while (counted < bins_.times && lag_of(counted) <= age - 1) {
                ++counted;
            }
            return origin.positions.cols() == atoms_ && origin.moments.cols() == age - 1 &&
                   origin.histogram.rows() == bins_.bins && origin.histogram.cols() == counted;
        },
        "this distribution of displacements");
}

}  // namespace ljmd
