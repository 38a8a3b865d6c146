#include "observables/transport/mean_square_displacement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "execution/loops.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/core/archived_count.hpp"
#include "observables/statistics/known_quantities.hpp"
#include "observables/transport/centre_frame.hpp"
#include "observables/transport/overlapping_origins.hpp"
#include "observables/transport/time_origins.hpp"

namespace ljmd {

namespace {

/// Weights of the values in the slope of the least-squares line through the times from `start` on.
Eigen::VectorXd slope_weights(const LagTimes& lags, double start) {
    const Index times = lags.count + 1;
    const auto first = static_cast<Index>(std::ceil(start / lags.spacing * (1.0 - 1e-9)));
    const Index count = times - first;
    if (first < 0 || count < 2) {
        throw ContractViolation(
            fmt::format("no line goes through the times from {} to {}", start, lags.time(lags.count)));
    }
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(times);
    const double middle = 0.5 * (lags.time(first) + lags.time(lags.count));
    for (Index k = first; k < times; ++k) {
        weights[k] = lags.time(k) - middle;
    }
    return weights / weights.squaredNorm();
}

/// Sum of squared differences, block by block.
double square_distance(const Execution& execution, const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b) {
    return join_blocks(
        execution, a.cols(), sum_block, 0.0,
        [&](Index first, Index last) {
            return (a.middleCols(first, last - first) - b.middleCols(first, last - first)).squaredNorm();
        },
        [](double& sum, double block) { sum += block; });
}

}  // namespace

MeanSquareDisplacement::MeanSquareDisplacement(Index atoms, const LagTimes& lags, Index origins, double fit_start)
    : atoms_(atoms),
      lags_(lags),
      every_(lags.every),
      frames_between_origins_(frames_between_origins(lags, origins)),
      slope_(slope_weights(lags, fit_start)),
      means_(lags.count + 2, Covariance::diagonal) {}

void MeanSquareDisplacement::sample(const State& state, const Evaluation& /*evaluation*/) {
    ++samples_;
    const Eigen::Matrix3Xd positions = positions_about_centre(state);
    if (frames_ % frames_between_origins_ == 0) {
        origins_.push_back({positions, Eigen::VectorXd()});
    }
    ++frames_;
    for (Origin& origin : origins_) {
        const double sum = square_distance(state.execution(), positions, origin.positions);
        origin.found.conservativeResize(origin.found.size() + 1);
        origin.found[origin.found.size() - 1] = sum / static_cast<double>(atoms_);
    }
    if (origins_.front().found.size() <= lags_.count) {
        return;
    }
    Eigen::VectorXd found(means_.width());
    found.head(lags_.count + 1) = origins_.front().found;
    found[lags_.count + 1] = slope_.dot(origins_.front().found) / 6.0;
    means_.add(found);
    origins_.erase(origins_.begin());
}

void MeanSquareDisplacement::interrupt() {
    origins_.clear();
    frames_ = 0;
}

std::vector<DataTable> MeanSquareDisplacement::tables() const {
    if (means_.samples() == 0) {
        return {};
    }
    DataTable table{"msd", {"time", "msd", "msd_standard_error"}, {}};
    for (Index k = 0; k <= lags_.count; ++k) {
        const Estimate msd = means_.estimate(k);
        table.rows.push_back({lags_.time(k), msd.mean, msd.standard_error});
    }
    return {table};
}

std::vector<ObservableAverage> MeanSquareDisplacement::observables() const {
    if (means_.samples() == 0) {
        return {};
    }
    if (atoms_ == 1) {
        return {average_of("diffusion", std::nullopt, moves_with_centre)};
    }
    const double independent = independent_origins(slope_, frames_between_origins_, means_.samples());
    return {average_of("diffusion", overlapping_estimate(means_, lags_.count + 1, independent))};
}

void MeanSquareDisplacement::archive(Archive& a) {
    a(samples_, frames_, origins_, means_);
    require_count(samples_);
    require_count(frames_);
    require_origins(
        origins_, frames_, frames_between_origins_, lags_.count,
        [&](const Origin& origin, Index age) {
            return origin.positions.cols() == atoms_ && origin.found.size() == age;
        },
        "this displacement");
}

}  // namespace ljmd
