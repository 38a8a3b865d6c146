#include "judge/missing_pairs.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <utility>

namespace ljmd {

namespace {

/// Missing pairs are found if they explain all of a difference but this part.
constexpr double unexplained_by_pairs = 1e-2;

/// The pairs among atoms with wrong forces, as far as a system of equations is solved for them.
constexpr std::size_t most_pairs = 400;

double norm_of_all(const std::vector<Vec3>& vectors) {
    double sum = 0.0;
    for (const Vec3& v : vectors) {
        sum += v.squaredNorm();
    }
    return std::sqrt(sum);
}

}  // namespace

MissingPairs::MissingPairs(const std::vector<Vec3>& positions, const std::vector<Vec3>& found,
                           const std::vector<Vec3>& right, const Vec3& edges, const PairPotential& potential,
                           double noise)
    : cutoff_(potential.cutoff().radius), pairs_(positions, edges, cutoff_) {
    for (std::size_t i = 0; i < found.size(); ++i) {
        lacking_.emplace_back(right[i] - found[i]);
        wrong_.push_back(!(lacking_[i].norm() <= noise));
    }
    for (const SummedPairs::Pair& pair : pairs_.pairs()) {
        if (wrong_[pair.i] && wrong_[pair.j]) {
            candidates_.push_back(pair);
            forces_.emplace_back(potential(pair.distance).w * pair.separation);
        }
    }
}

Index MissingPairs::wrong_atoms() const {
    return std::ranges::count(wrong_, true);
}

std::vector<SummedPairs::Pair> MissingPairs::farthest_in(const std::vector<Vec3>& earlier, const Vec3& edges) const {
    const auto distance_then = [&](const SummedPairs::Pair& pair) {
        const Vec3 apart = earlier[pair.i] - earlier[pair.j];
        const Vec3 images = (apart.array() / edges.array()).round();
        return (apart - images.cwiseProduct(edges)).norm();
    };
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t k = 0; k < candidates_.size(); ++k) {
        order.emplace_back(-distance_then(candidates_[k]), k);
    }
    std::ranges::sort(order);
    std::vector<Vec3> rest = lacking_;
    double least = unexplained_by_pairs * norm_of_all(rest);
    std::size_t missing = 0;
    for (std::size_t n = 0; n < order.size(); ++n) {
        take_off(rest, order[n].second);
        if (const double left = norm_of_all(rest); left < least) {
            least = left;
            missing = n + 1;
        }
    }
    if (missing == 0 || -order[missing - 1].first < cutoff_) {
        return {};
    }
    const double middle = -order[missing / 2].first;
    const auto as_far = std::ranges::count_if(
        pairs_.pairs(), [&](const SummedPairs::Pair& pair) { return distance_then(pair) >= middle; });
    if (as_far > 2 * static_cast<std::ptrdiff_t>(missing)) {
        return {};
    }
    std::vector<SummedPairs::Pair> found;
    for (std::size_t n = 0; n < missing; ++n) {
        found.push_back(candidates_[order[n].second]);
    }
    return found;
}

std::vector<SummedPairs::Pair> MissingPairs::of_any() const {
    if (candidates_.empty() || candidates_.size() > most_pairs) {
        return {};
    }
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(static_cast<Index>(3 * lacking_.size()), std::ssize(candidates_));
    Eigen::VectorXd right(static_cast<Index>(3 * lacking_.size()));
    for (std::size_t i = 0; i < lacking_.size(); ++i) {
        right.segment<3>(static_cast<Index>(3 * i)) = lacking_[i];
    }
    for (std::size_t k = 0; k < candidates_.size(); ++k) {
        matrix.block<3, 1>(static_cast<Index>(3 * candidates_[k].i), static_cast<Index>(k)) = forces_[k];
        matrix.block<3, 1>(static_cast<Index>(3 * candidates_[k].j), static_cast<Index>(k)) = -forces_[k];
    }
    const Eigen::VectorXd parts = matrix.colPivHouseholderQr().solve(right);
    std::vector<Vec3> rest = lacking_;
    std::vector<SummedPairs::Pair> missing;
    for (std::size_t k = 0; k < candidates_.size(); ++k) {
        const double part = parts[static_cast<Index>(k)];
        if (std::abs(part - std::round(part)) > unexplained_by_pairs) {
            return {};
        }
        if (std::round(part) == 1.0) {
            missing.push_back(candidates_[k]);
            take_off(rest, k);
        }
    }
    return norm_of_all(rest) < unexplained_by_pairs * norm_of_all(lacking_) ? missing
                                                                            : std::vector<SummedPairs::Pair>{};
}

void MissingPairs::take_off(std::vector<Vec3>& rest, std::size_t k) const {
    rest[candidates_[k].i] -= forces_[k];
    rest[candidates_[k].j] += forces_[k];
}

}  // namespace ljmd
