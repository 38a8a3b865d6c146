#include "observables/structure/structure_factor.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "execution/loops.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

Index shell_count(double k_max, double width) {
    if (!(width > 0.0) || !(k_max > 0.0)) {
        throw ContractViolation(fmt::format("no shells of thickness {} up to k = {}", width, k_max));
    }
    return static_cast<Index>(k_max / width) + 1;
}

}  // namespace

DensityModes::Numbers StructureFactor::largest_numbers(const Box& box, double k_max) {
    const Vec3 numbers = k_max * box.edges() / (2.0 * std::numbers::pi);
    return {static_cast<Index>(numbers[0]), static_cast<Index>(numbers[1]), static_cast<Index>(numbers[2])};
}

StructureFactor::StructureFactor(const Box& box, double k_max, double width, Method method, Every every)
    : unit_(2.0 * std::numbers::pi / box.edges().array()),
      k_max_(k_max),
      width_(width),
      every_(every),
      largest_(largest_numbers(box, k_max)),
      modes_(method == Method::direct ? direct_density_modes(box, largest_) : grid_density_modes(box, largest_)),
      vectors_(Eigen::VectorXd::Zero(shell_count(k_max, width))),
      magnitudes_(Eigen::VectorXd::Zero(shell_count(k_max, width))),
      means_(shell_count(k_max, width), Covariance::diagonal) {
    for (Index n_x = -largest_[0]; n_x <= largest_[0]; ++n_x) {
        for_each_rod(n_x, [&](Index n_y) {
            for_each_in_rod(n_x, n_y, [&](Index, Index shell, double k) {
                vectors_[shell] += 1.0;
                magnitudes_[shell] += k;
            });
        });
    }
    if (vectors_.sum() == 0.0) {
        throw ContractViolation(fmt::format("the box allows no wave vector up to k = {}", k_max));
    }
    magnitudes_ = magnitudes_.cwiseQuotient(vectors_.cwiseMax(1.0));
}

Index StructureFactor::rod_length(Index n_x, Index n_y) const {
    const double in_plane =
        std::pow(static_cast<double>(n_x) * unit_[0], 2) + std::pow(static_cast<double>(n_y) * unit_[1], 2);
    const double rest = k_max_ * k_max_ - in_plane;
    return rest < 0.0 ? 0 : std::min(static_cast<Index>(std::sqrt(rest) / unit_[2]), largest_[2]) + 1;
}

template <class Visit>
void StructureFactor::for_each_rod(Index n_x, Visit visit) const {
    for (Index n_y = -largest_[1]; n_y <= largest_[1]; ++n_y) {
        if (rod_length(n_x, n_y) > 0) {
            visit(n_y);
        }
    }
}

template <class Visit>
void StructureFactor::for_each_in_rod(Index n_x, Index n_y, Visit visit) const {
    const bool at_zero = n_y > 0 || (n_y == 0 && n_x > 0);
    for (Index n_z = at_zero ? 0 : 1; n_z < rod_length(n_x, n_y); ++n_z) {
        const Vec3 n(static_cast<double>(n_x), static_cast<double>(n_y), static_cast<double>(n_z));
        const double k = n.cwiseProduct(unit_).norm();
        visit(n_z, std::min(static_cast<Index>(k / width_), vectors_.size() - 1), k);
    }
}

void StructureFactor::sample(const State& state, const Evaluation& /*evaluation*/) {
    modes_->prepare(state);
    const auto powers_of_planes = [&](Index first, Index last) {
        Eigen::VectorXd powers = Eigen::VectorXd::Zero(vectors_.size());
        std::vector<std::complex<double>> rod;
        for (Index plane = first; plane < last; ++plane) {
            const Index n_x = plane - largest_[0];
            for_each_rod(n_x, [&](Index n_y) {
                rod.resize(static_cast<std::size_t>(rod_length(n_x, n_y)));
                modes_->get(n_x, n_y, rod);
                for_each_in_rod(n_x, n_y, [&](Index n_z, Index shell, double) {
                    powers[shell] += std::norm(rod[static_cast<std::size_t>(n_z)]);
                });
            });
        }
        return powers;
    };
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(vectors_.size());
    const Eigen::VectorXd powers =
        join_blocks(state.execution(), 2 * largest_[0] + 1, 1, zero, powers_of_planes,
                    [](Eigen::VectorXd& sum, const Eigen::VectorXd& block) { sum += block; });
    means_.add(powers.cwiseQuotient(vectors_.cwiseMax(1.0)) / static_cast<double>(state.count()));
}

std::vector<DataTable> StructureFactor::tables() const {
    if (samples() == 0) {
        return {};
    }
    DataTable table{"sk", {"k", "S", "S_standard_error", "vectors"}, {}};
    for (Index shell = 0; shell < vectors_.size(); ++shell) {
        if (vectors_[shell] > 0.0) {
            const Estimate s = means_.estimate(shell);
            table.rows.push_back({magnitudes_[shell], s.mean, s.standard_error, vectors_[shell]});
        }
    }
    return {table};
}

}  // namespace ljmd
