#pragma once

#include <memory>

#include "core/schedule.hpp"
#include "ljmd/detail/observables/analysis.hpp"
#include "ljmd/observables/statistics/blocking.hpp"
#include "observables/structure/density_modes.hpp"

namespace ljmd {

/// Structure factor at the wave vectors of a periodic box:
///
///     S(k) = <|rho(k)|^2>/N,   rho(k) = sum_j exp(-i k . r_j),   0 < |k| <= k_max
///
/// averaged over all wave vectors in shells of thickness `width`; empty shells are left out. Standard errors by block
/// averaging over the sampled configurations. Table `sk`: k (mean of |k| in the shell) [1/sigma], S, S_standard_error,
/// vectors (k and -k count once). Source: Hansen and McDonald, Theory of Simple Liquids, section 4.1;
/// Verlet (1968), doi:10.1103/PhysRev.165.201
class StructureFactor : public Analysis {
  public:
    /// How rho(k) is computed, see density_modes.hpp.
    enum class Method { direct, grid };

    /// Largest numbers (n_x, n_y, n_z), each along its direction, with |k| <= k_max.
    [[nodiscard]] static DensityModes::Numbers largest_numbers(const Box& box, double k_max);

    /// @throws ContractViolation if the box has no wave vector up to k_max, or unless the width is positive
    StructureFactor(const Box& box, double k_max, double width, Method method, Every every);

    [[nodiscard]] bool due(Index step) const override { return every_.due(step); }
    void sample(const State& state, const Evaluation& evaluation) override;
    [[nodiscard]] Index samples() const override { return means_.samples(); }
    [[nodiscard]] std::vector<DataTable> tables() const override;
    void archive(Archive& a) override { a(means_); }

  private:
    /// Calls visit(n_z, shell, |k|) for the wave vectors of a rod, with one of each pair k and -k.
    template <class Visit>
    void for_each_in_rod(Index n_x, Index n_y, Visit visit) const;
    /// Calls visit(n_y) for the rods with n_x.
    template <class Visit>
    void for_each_rod(Index n_x, Visit visit) const;
    [[nodiscard]] Index rod_length(Index n_x, Index n_y) const;

    Vec3 unit_;  ///< 2 pi/L
    double k_max_;
    double width_;
    Every every_;
    DensityModes::Numbers largest_;
    std::unique_ptr<DensityModes> modes_;
    Eigen::VectorXd vectors_;     ///< number of wave vectors in each shell
    Eigen::VectorXd magnitudes_;  ///< mean |k| in each shell
    BlockingAccumulator means_;   ///< S of each shell
};

}  // namespace ljmd
