#pragma once

#include <memory>

#include "ljmd/core/schedule.hpp"
#include "ljmd/observables/analysis.hpp"
#include "ljmd/observables/statistics/blocking.hpp"
#include "ljmd/observables/structure/density_modes.hpp"

namespace ljmd {

/// Structure factor at the wave vectors that the box allows:
///
///     S(k) = <|rho(k)|^2>/N,   rho(k) = sum_j exp(-i k . r_j),   0 < |k| <= k_max
///
/// averaged over all wave vectors in shells of thickness `width`; shells that hold none are left out. Standard errors
/// by blocking over the sampled configurations. Table `sk`: k (mean of |k| in the shell) [1/sigma], S,
/// S_standard_error, vectors (k and -k count once). Source: Hansen and McDonald, Theory of Simple Liquids, section 4.1;
/// Verlet (1968), doi:10.1103/PhysRev.165.201
class StructureFactor : public Analysis {
  public:
    /// Which way rho(k) is computed.
    enum class Method { direct, grid };

    /// The numbers (n_x, n_y, n_z) that |k| <= k_max allows, in each direction.
    [[nodiscard]] static DensityModes::Numbers largest_numbers(const Box& box, double k_max);

    /// @throws ContractViolation when the box allows no wave vector up to k_max, or the width is not positive
    StructureFactor(const Box& box, double k_max, double width, Method method, Every every);

    [[nodiscard]] bool due(Index step) const override { return every_.due(step); }
    void sample(const State& state, const Evaluation& evaluation) override;
    [[nodiscard]] Index samples() const override { return means_.samples(); }
    [[nodiscard]] std::vector<DataTable> tables() const override;
    void archive(Archive& a) override { a(means_); }

  private:
    /// Calls visit(n_z, shell, |k|) for the wave vectors of a rod, one of each pair k and -k.
    template <class Visit>
    void for_each_in_rod(Index n_x, Index n_y, Visit visit) const;
    /// Calls visit(n_x, n_y) for the rods of a plane.
    template <class Visit>
    void for_each_rod(Index n_x, Visit visit) const;
    [[nodiscard]] Index rod_length(Index n_x, Index n_y) const;

    Vec3 unit_;  ///< 2 pi/L
    double k_max_;
    double width_;
    Every every_;
    DensityModes::Numbers largest_;
    std::unique_ptr<DensityModes> modes_;
    Eigen::VectorXd vectors_;     ///< in each shell
    Eigen::VectorXd magnitudes_;  ///< mean |k| in each shell
    BlockingAccumulator means_;   ///< S of each shell
};

}  // namespace ljmd
