#pragma once

#include <optional>

#include "core/schedule.hpp"
#include "ljmd/detail/observables/analysis.hpp"
#include "ljmd/observables/statistics/blocking.hpp"
#include "observables/transport/lag_times.hpp"

namespace ljmd {

/// Where a distinct_van_hove is measured.
struct DistanceBins {
    double radius;  ///< largest distance [sigma], at most half the shortest edge
    Index bins;     ///< between 0 and radius
};

/// Distinct part of van Hove's function: where the others are, a time t after an atom was at the origin,
///
///     G_d(r, t) = 1/N sum over pairs i != j of <delta(r - |r_j(t) - r_i(0)|)>/(4 pi r^2)
///
/// It begins as rho g(r), and ends as rho (N - 1)/N; over the whole box its integral is N - 1 at all times. Distances
/// are those of the nearest images, of positions about the centre of mass (centre_frame.hpp). Errors by block averaging
/// over time origins.
///
/// Table `gd`: time, r (middle of the bin), G_d, error. Takes a time of N^2 for each time of each origin.
/// Source: van Hove (1954), doi:10.1103/PhysRev.95.249
class DistinctVanHove : public Analysis {
  public:
    /// @param between  configurations from one time origin to the next; the last time of one may be the next one
    /// @throws ContractViolation unless the radius is positive, and lags.count <= between
    DistinctVanHove(Index atoms, const LagTimes& lags, Index between, const DistanceBins& bins);

    [[nodiscard]] bool due(Index step) const override { return every_.due(step); }
    void sample(const State& state, const Evaluation& evaluation) override;
    void interrupt() override;
    [[nodiscard]] Index samples() const override { return samples_; }
    [[nodiscard]] std::vector<DataTable> tables() const override;
    void archive(Archive& a) override;

    /// Pairs at each time of the last complete origin that are farther apart than the radius, per atom: with the
    /// integral of G_d up to it they are N - 1.
    [[nodiscard]] const Eigen::VectorXd& beyond() const { return beyond_; }

  private:
    struct Origin {
        Eigen::Matrix3Xd positions;  ///< about the centre of mass, by id
        Eigen::MatrixXd counts;      ///< pairs in each bin and, last, beyond them, (bins + 1, times passed)

        void archive(Archive& a) { a(positions, counts); }
    };

    [[nodiscard]] Eigen::VectorXd counted(const Eigen::Matrix3Xd& positions, const State& state) const;

    Index atoms_;
    LagTimes lags_;
    Every every_;
    Index between_;
    DistanceBins bins_;
    Index samples_ = 0;
    Index frames_ = 0;  ///< since the last interruption
    std::optional<Origin> origin_;
    Eigen::VectorXd beyond_;
    BlockingAccumulator means_;  ///< pairs per atom in each bin, time by time
};

}  // namespace ljmd
