#pragma once

#include "core/schedule.hpp"
#include "ljmd/detail/observables/analysis.hpp"
#include "ljmd/observables/statistics/blocking.hpp"
#include "observables/fourier.hpp"
#include "observables/structure/coordination_number.hpp"

namespace ljmd {

/// Radial distribution function from a histogram of pair distances, and quantities that follow from it.
///
///     g(r_k) = <n_k> / (N (N - 1)/V * shell_k),  shell_k = (4 pi/3) (r_{k+1}^3 - r_k^3)
///     S(k)   = 1 + 4 pi ((N - 1)/V) integral from 0 to R of r^2 (g(r) - 1) sin(k r)/(k r) dr
///
/// n_k: ordered pairs with distance in [r_k, r_{k+1}). With N (N - 1) instead of N^2, g of an ideal gas is 1 for every
/// N. The integral is a sine transform by the midpoint rule. It lacks g beyond R, which causes ripples of wave length 2
/// pi/R, and says nothing about waves longer than R: the curve begins at k = 2 pi/R. StructureFactor has no such limit
/// but the box.
/// V is that of each configuration. Where a barostat has made half an edge shorter than R, g has no values (NaN) beyond
/// the shortest half of all sampled configurations, and there are no coordination number and no S(k). Standard errors
/// by block averaging over the sampled configurations. Table `rdf`: r (middle of the bin) [sigma], g, g_standard_error,
/// coordination_number (atoms within the end of the bin), its error. Table `sk_from_rdf`: k [1/sigma], S, its error,
/// for k = pi m/(4 R), m = 8 ... bins; there is none with fewer bins. Observable: coordination_number, of atoms within
/// the first minimum of g, see coordination_number.hpp. Source: Allen and Tildesley, 2nd ed., section 8.2; Verlet
/// (1968), doi:10.1103/PhysRev.165.201
class RadialDistribution : public Analysis {
  public:
    /// @param bins    at least 1
    /// @param radius  R, largest distance [sigma], <= L/2 of the box at first
    RadialDistribution(Index bins, double radius, Every every);

    [[nodiscard]] bool due(Index step) const override { return every_.due(step); }
    void sample(const State& state, const Evaluation& evaluation) override;
    [[nodiscard]] Index samples() const override { return means_.samples(); }
    [[nodiscard]] std::vector<DataTable> tables() const override;
    [[nodiscard]] std::vector<ObservableAverage> observables() const override;
    void archive(Archive& a) override { a(means_, neighbors_, reach_); }

  private:
    [[nodiscard]] Eigen::VectorXd structure_factor(const Eigen::VectorXd& g, double density) const;
    [[nodiscard]] double width() const { return radius_ / static_cast<double>(bins_); }
    [[nodiscard]] double wave_number(Index m) const;

    Index bins_;
    double radius_;
    Every every_;
    SineTransform sines_;
    CoordinationNumber::Division division_;
    BlockingAccumulator means_;  ///< g, coordination number and S, each for all bins
    CoordinationNumber neighbors_;
    double reach_;  ///< R, or half the shortest edge of all samples where that is less
};

}  // namespace ljmd
