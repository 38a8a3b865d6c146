#pragma once

#include "ljmd/core/schedule.hpp"
#include "ljmd/neighbors/linked_cells.hpp"
#include "ljmd/observables/analysis.hpp"
#include "ljmd/observables/blocking.hpp"

namespace ljmd {

/// Radial distribution function by a histogram of pair distances.
///
///     g(r_k) = <n_k> / (N (N - 1)/V * shell_k),  shell_k = (4 pi/3) (r_{k+1}^3 - r_k^3)
///
/// n_k: ordered pairs with distance in [r_k, r_{k+1}). N (N - 1), not N^2, makes g of an ideal gas 1 for every N.
/// Standard errors by blocking over the sampled configurations.
/// Result `rdf`: r (middle of the bin) [sigma], g, g_standard_error, coordination_number (atoms closer than the bin's
/// end). Source: Allen and Tildesley, 2nd ed., section 8.2; Verlet (1968), doi:10.1103/PhysRev.165.201
class RadialDistribution : public Analysis {
  public:
    /// @param bins    at least 1
    /// @param radius  largest distance [sigma], <= L/2
    RadialDistribution(Index bins, double radius, Every every);

    [[nodiscard]] bool due(Index step) const override { return every_.due(step); }
    void sample(const State& state) override;
    [[nodiscard]] Index samples() const override { return histogram_.samples(); }
    [[nodiscard]] DataTable result() const override;
    void archive(Archive& a) override { a(ideal_pairs_per_volume_, atoms_, histogram_); }

  private:
    Index bins_;
    double radius_;
    Every every_;
    double ideal_pairs_per_volume_ = 0.0;  ///< N (N - 1)/V of the last configuration
    Index atoms_ = 0;
    LinkedCells search_;
    BlockingAccumulator histogram_;  ///< g of each bin
};

}  // namespace ljmd
