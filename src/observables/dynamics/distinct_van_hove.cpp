#include "observables/dynamics/distinct_van_hove.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "execution/loops.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/core/archived_count.hpp"
#include "observables/transport/centre_frame.hpp"

namespace ljmd {

DistinctVanHove::DistinctVanHove(Index atoms, const LagTimes& lags, Index between, const DistanceBins& bins)
    : atoms_(atoms),
      lags_(lags),
      every_(lags.every),
      between_(between),
      bins_(bins),
      beyond_(Eigen::VectorXd::Zero(lags.count + 1)),
      means_(bins.bins * (lags.count + 1), Covariance::diagonal) {
    if (lags.count > between || !(bins.radius > 0.0)) {
        throw ContractViolation(fmt::format("no {} times of origins {} configurations apart, with distances up to {}",
                                            lags.count, between, bins.radius));
    }
}

void DistinctVanHove::sample(const State& state, const Evaluation& /*evaluation*/) {
    ++samples_;
    const bool begins = frames_ % between_ == 0;
    ++frames_;
    if (!begins && !origin_) {
        return;  // until the next origin
    }
    const Eigen::Matrix3Xd positions = positions_about_centre(state);
    const auto count = [&] {
        origin_->counts.conservativeResize(Eigen::NoChange, origin_->counts.cols() + 1);
        origin_->counts.rightCols(1) = counted(positions, state);
    };
    if (origin_) {
        count();
        if (origin_->counts.cols() == lags_.count + 1) {
            const Eigen::MatrixXd& counts = origin_->counts;
            means_.add(Eigen::VectorXd(counts.topRows(bins_.bins).reshaped()) / static_cast<double>(atoms_));
            beyond_ = counts.row(bins_.bins).transpose() / static_cast<double>(atoms_);
            origin_.reset();
        }
    }
    if (begins) {
        origin_ = Origin{positions, Eigen::MatrixXd(bins_.bins + 1, 0)};
        count();
    }
}

void DistinctVanHove::interrupt() {
    origin_.reset();
    frames_ = 0;
}

/// Pairs of an atom at the origin and another one now.
Eigen::VectorXd DistinctVanHove::counted(const Eigen::Matrix3Xd& positions, const State& state) const {
    const Vec3 edges = state.box().edges();
    const double per_length = static_cast<double>(bins_.bins) / bins_.radius;
    constexpr Index block = 16;  // atoms at the origin; whole numbers are summed, in whatever order
    const auto of_block = [&](Index first, Index last) {
        Eigen::VectorXd counts = Eigen::VectorXd::Zero(bins_.bins + 1);
        Eigen::ArrayXd squares(atoms_);
        for (Index i = first; i < last; ++i) {
            squares.setZero();
            for (Index axis = 0; axis < 3; ++axis) {
                const Eigen::ArrayXd apart =
                    (positions.row(axis).transpose().array() - origin_->positions(axis, i)) / edges[axis];
                squares += ((apart - apart.round()) * edges[axis]).square();
            }
            for (Index j = 0; j < atoms_; ++j) {
                const double place = std::sqrt(squares[j]) * per_length;
                if (j != i) {
                    counts[place < static_cast<double>(bins_.bins) ? static_cast<Index>(place) : bins_.bins] += 1.0;
                }
            }
        }
        return counts;
    };
    return join_blocks(state.execution(), atoms_, block, Eigen::VectorXd(Eigen::VectorXd::Zero(bins_.bins + 1)),
                       of_block, [](Eigen::VectorXd& sum, const Eigen::VectorXd& part) { sum += part; });
}

std::vector<DataTable> DistinctVanHove::tables() const {
    if (means_.samples() == 0) {
        return {};
    }
    DataTable gd{"gd", {"time", "r", "G_d", "G_d_standard_error"}, {}};
    const double width = bins_.radius / static_cast<double>(bins_.bins);
    for (Index time = 0; time <= lags_.count; ++time) {
        for (Index bin = 0; bin < bins_.bins; ++bin) {
            const Estimate pairs = means_.estimate(time * bins_.bins + bin);
            const auto inner = static_cast<double>(bin);
            const double volume =
                4.0 / 3.0 * std::numbers::pi * (3.0 * inner * (inner + 1.0) + 1.0) * width * width * width;
            gd.rows.push_back(
                {lags_.time(time), (inner + 0.5) * width, pairs.mean / volume, pairs.standard_error / volume});
        }
    }
    return {gd};
}

void DistinctVanHove::archive(Archive& a) {
    a(samples_, frames_, origin_, beyond_, means_);
    require_count(samples_);
    require_count(frames_);
    // The origin of the last `between` frames is incomplete as long as it lacks times.
    const Index age = frames_ == 0 ? 0 : (frames_ - 1) % between_ + 1;
    const bool is_open = frames_ > 0 && age <= lags_.count;
    if (beyond_.size() != lags_.count + 1 || origin_.has_value() != is_open ||
        (origin_ && (origin_->positions.cols() != atoms_ || origin_->counts.rows() != bins_.bins + 1 ||
                     origin_->counts.cols() != age))) {
        throw CheckpointError("its time origin is not one of this distribution of distances");
    }
}

}  // namespace ljmd
