#pragma once

#include <vector>

#include "core/schedule.hpp"
#include "ljmd/detail/observables/analysis.hpp"
#include "ljmd/observables/statistics/blocking.hpp"
#include "observables/transport/lag_times.hpp"

namespace ljmd {

/// Where a self_van_hove is measured.
struct DisplacementBins {
    double radius;  ///< largest displacement that is counted [sigma]
    Index bins;     ///< between 0 and radius
    Index times;    ///< G_s is given at so many, equally spaced up to the largest one
};

/// Distribution of the displacements of single atoms, and by how much it is not normal:
///
///     G_s(r, t)  = 1/N sum_i <delta(r - |r_i(t) - r_i(0)|)>/(4 pi r^2)     self part of van Hove's function
///     alpha_2(t) = 3 <dr^4>/(5 <dr^2>^2) - 1                                non-Gaussian parameter
///
/// The integral of 4 pi r^2 G_s over all r is 1; alpha_2 is 0 for a normal distribution. Positions are unwrapped and
/// relative to the centre of mass (centre_frame.hpp). Time origins are equally spaced, `origins` of them within the
/// largest time. Errors by block averaging over origins, that of alpha_2 with the covariance of its two means.
///
/// Tables: `gs`: time, r (middle of the bin), G_s, error. `alpha2`: time, alpha_2, error.
/// Memory: 24 bytes per atom and origin. Source: Rahman (1964), doi:10.1103/PhysRev.136.A405
class SelfVanHove : public Analysis {
  public:
    /// @param origins  at least 1; more than lags.count have no effect
    /// @throws ContractViolation unless radius, bins and times are positive, and there are as many times
    SelfVanHove(Index atoms, const LagTimes& lags, Index origins, const DisplacementBins& bins);

    [[nodiscard]] bool due(Index step) const override { return every_.due(step); }
    void sample(const State& state, const Evaluation& evaluation) override;
    void interrupt() override;
    [[nodiscard]] Index samples() const override { return samples_; }
    [[nodiscard]] std::vector<DataTable> tables() const override;
    void archive(Archive& a) override;

  private:
    struct Origin {
        Eigen::Matrix3Xd positions;  ///< relative to the centre of mass, by id
        Eigen::Matrix2Xd moments;    ///< <dr^2>, <dr^4> at each time passed so far, but for the first
        Eigen::MatrixXd histogram;   ///< atoms in each bin, (bins, times), at the times of G_s passed so far

        void archive(Archive& a) { a(positions, moments, histogram); }
    };

    void add_to(Origin& origin, const Eigen::Matrix3Xd& positions) const;
    [[nodiscard]] Index lag_of(Index time) const;  ///< of the times of G_s, from 0

    Index atoms_;
    LagTimes lags_;
    Every every_;
    Index frames_between_origins_;
    DisplacementBins bins_;
    Index samples_ = 0;
    Index frames_ = 0;                          ///< since the last interruption
    std::vector<Origin> origins_;               ///< incomplete ones, oldest first
    std::vector<BlockingAccumulator> moments_;  ///< of each time after the first
    BlockingAccumulator histograms_;            ///< part of the atoms in each bin, time by time
};

}  // namespace ljmd
