#pragma once

#include "core/schedule.hpp"
#include "ljmd/observables/statistics/blocking.hpp"
#include "observables/transport/lag_times.hpp"

namespace ljmd {

/// Mean-square displacement, and diffusion by Einstein's relation:
///
///     msd(t) = 1/N sum_i |r_i(t0 + t) - r_i(t0)|^2,   D = 1/6 d msd/dt
///
/// Positions are unwrapped and relative to the centre of mass (centre_frame.hpp). Time origins t0 are equally spaced,
/// `origins` of them within the largest time. The slope is of the least-squares line from fit_start to the largest
/// time, for each origin. Standard errors of msd by block averaging over origins, the error of D by their known
/// overlap, see overlapping_origins.hpp.
///
/// Table `msd`: time [tau], msd [sigma^2], its error. Observable: diffusion.
/// Memory: 24 bytes per atom and origin. Source: Allen and Tildesley, 2nd ed., section 8.4
class MeanSquareDisplacement : public Analysis {
  public:
    /// @param origins  at least 1; more than lags.count have no effect
    /// @throws ContractViolation unless at least two times lie between fit_start [tau] and the largest one, both
    /// included
    MeanSquareDisplacement(Index atoms, const LagTimes& lags, Index origins, double fit_start);

    [[nodiscard]] bool due(Index step) const override { return every_.due(step); }
    void sample(const State& state, const Evaluation& evaluation) override;
    void interrupt() override;
    [[nodiscard]] Index samples() const override { return samples_; }
    [[nodiscard]] std::vector<DataTable> tables() const override;
    [[nodiscard]] std::vector<ObservableAverage> observables() const override;
    void archive(Archive& a) override;

  private:
    struct Origin {
        Eigen::Matrix3Xd positions;  ///< relative to the centre of mass, by id
        Eigen::VectorXd found;       ///< msd at each time passed so far

        void archive(Archive& a) { a(positions, found); }
    };

    Index atoms_;
    LagTimes lags_;
    Every every_;
    Index frames_between_origins_;
    Eigen::VectorXd slope_;  ///< weights of the least-squares line: slope = slope_ . msd
    Index samples_ = 0;
    Index frames_ = 0;             ///< frames since the last interruption
    std::vector<Origin> origins_;  ///< incomplete origins, oldest first
    BlockingAccumulator means_;    ///< msd at each time, then D
};

}  // namespace ljmd
