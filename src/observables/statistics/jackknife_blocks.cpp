#include "ljmd/detail/observables/statistics/jackknife_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

constexpr std::size_t most_blocks = 64;
constexpr std::size_t least_blocks = 16;

Eigen::VectorXd sum_of(const std::vector<Eigen::VectorXd>& means, Index width) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(width);
    for (const Eigen::VectorXd& mean : means) {
        sum += mean;
    }
    return sum;
}

}  // namespace

void JackknifeBlocks::add(const Eigen::VectorXd& sample) {
    pending_ += sample;
    ++collected_;
    if (collected_ < length_) {
        return;
    }
    means_.emplace_back(pending_ / static_cast<double>(length_));
    pending_.setZero();
    collected_ = 0;
    if (means_.size() < most_blocks) {
        return;
    }
    for (std::size_t k = 0; k < most_blocks / 2; ++k) {
        means_[k] = 0.5 * (means_[2 * k] + means_[2 * k + 1]);
    }
    means_.resize(most_blocks / 2);
    length_ *= 2;
}

Eigen::VectorXd JackknifeBlocks::sum() const {
    return sum_of(means_, width_);
}

std::vector<Eigen::VectorXd> JackknifeBlocks::joined(std::size_t count) const {
    std::vector<Eigen::VectorXd> longer;
    for (std::size_t end = count; end <= means_.size(); end += count) {
        Eigen::VectorXd mean = means_[end - count];
        for (std::size_t k = end - count + 1; k < end; ++k) {
            mean += means_[k];
        }
        longer.emplace_back(mean / static_cast<double>(count));
    }
    return longer;
}

Eigen::VectorXd JackknifeBlocks::errors(const std::function<Eigen::VectorXd(const Eigen::VectorXd& means)>& function,
                                        Index shared) const {
    const Index count = std::max(Index{1}, (2 * shared + length_ - 1) / length_);
    const std::vector<Eigen::VectorXd> means = joined(static_cast<std::size_t>(count));
    if (means.size() < least_blocks) {
        return Eigen::VectorXd::Constant(function(mean()).size(), std::numeric_limits<double>::quiet_NaN());
    }
    const auto blocks = static_cast<double>(means.size());
    const Eigen::VectorXd all = sum_of(means, width_);
    std::vector<Eigen::VectorXd> without;
    without.reserve(means.size());
    for (const Eigen::VectorXd& block : means) {
        without.push_back(function((all - block) / (blocks - 1.0)));
    }
    Eigen::VectorXd mean = Eigen::VectorXd::Zero(without.front().size());
    for (const Eigen::VectorXd& each : without) {
        mean += each / blocks;
    }
    Eigen::VectorXd squares = Eigen::VectorXd::Zero(mean.size());
    for (const Eigen::VectorXd& each : without) {
        squares += (each - mean).cwiseAbs2();
    }
    const double unseen = static_cast<double>(shared) / (3.0 * static_cast<double>(count * length_));
    return ((blocks - 1.0) / blocks * squares / (1.0 - unseen)).cwiseSqrt();
}

void JackknifeBlocks::archive(Archive& a) {
    a(length_, collected_, pending_, means_);
    bool fits = length_ >= 1 && collected_ >= 0 && collected_ < length_ && pending_.size() == width_ &&
                means_.size() < most_blocks;
    for (const Eigen::VectorXd& block : means_) {
        fits = fits && block.size() == width_;
    }
    if (!fits) {
        throw CheckpointError("its blocks for a jackknife are not those of this series");
    }
}

}  // namespace ljmd
