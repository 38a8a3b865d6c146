#pragma once

#include "core/schedule.hpp"
#include "ljmd/observables/statistics/blocking.hpp"
#include "observables/transport/correlation_windows.hpp"
#include "observables/transport/lag_times.hpp"

namespace ljmd {

/// Velocity autocorrelation, diffusion by the Green-Kubo relation, and vibrational spectrum:
///
///     C(t)  = 1/N sum_i <v_i(0) . v_i(t)>                              C(0) = 3 T (1 - 1/N)
///     D(t)  = 1/3 integral from 0 to t of C                            by the trapezoidal rule; D = D(max_time)
///     I(w)  = 2/pi integral from 0 to max_time of C(t)/C(0) cos(w t) dt
///
/// Velocities are relative to the centre of mass (centre_frame.hpp). The integral of I over w >= 0 is 1, and I(0) = 6
/// D/(pi C(0)). Averages are over atoms and, within windows of twice the largest time, over all time origins; standard
/// errors by block averaging over windows. Tables: `vacf`: time [tau], vacf [epsilon/m], its error, vacf_normalized
/// C(t)/C(0), diffusion D(t) [sigma^2/tau], its error. `vibrational_spectrum`: angular_frequency [1/tau], spectrum
/// [tau], its error. Observable: diffusion_green_kubo. If configurations are too far apart (see green_kubo.hpp),
/// neither it nor D(t) has a value, and there is no spectrum. Correlations beyond max_time are missing in D and cause
/// ripples in I.
///
/// Long times: level n has the mean velocities of 2^n = m configurations in a row, one after the other. Of their
/// difference in time the variance is (m^2 - 1) h^2/6, so that C is smoothed over about m h:
///
///     C_n(t) = sum_{|j| < m} (m - |j|)/m^2 C(t + j h) = C(t) + (m^2 - 1) h^2/12 C''(t) + ...
///
/// It is given at times of more than half of the lags, t > m h lags/2, where C'' is small: for C ~ t^(-3/2) the bias is
/// below 1.25/lags^2 of C. The table `vacf` continues with these times, without D(t), which is by the first level
/// alone. Sources: Rahman (1964), doi:10.1103/PhysRev.136.A405; Kubo (1966), doi:10.1088/0034-4885/29/1/306; Ramirez et
/// al. (2010), doi:10.1063/1.3491098
class VelocityAutocorrelation : public Analysis {
  public:
    /// Times and, of each, configurations in a window, greater than lags.count.
    struct Level {
        LagTimes lags;
        Index window;
    };

    /// @param levels  the first is as above; each further one has twice the spacing of the one before
    /// @throws ContractViolation without levels
    VelocityAutocorrelation(Index atoms, const std::vector<Level>& levels);

    [[nodiscard]] bool due(Index step) const override { return every_.due(step); }
    void sample(const State& state, const Evaluation& evaluation) override;
    void interrupt() override;
    [[nodiscard]] Index samples() const override { return samples_; }
    [[nodiscard]] std::vector<DataTable> tables() const override;
    [[nodiscard]] std::vector<ObservableAverage> observables() const override;
    void archive(Archive& a) override;

  private:
    /// C of mean velocities.
    struct Coarse {
        LagTimes lags;
        CorrelationWindows window;
        BlockingAccumulator means;
        Eigen::VectorXd pending;  ///< mean velocities of the level before that wait for the next ones; empty if none do

        void archive(Archive& a) { a(window, means, pending); }
    };

    void add_to_coarse(Eigen::VectorXd velocities, const Execution& execution);
    void add_long_times(DataTable& vacf) const;
    [[nodiscard]] Estimate diffusion() const;
    [[nodiscard]] double change_of_diffusion() const;  ///< if only every second configuration is used

    Index atoms_;
    LagTimes lags_;
    Every every_;
    CosineTransform cosines_;
    Index samples_ = 0;
    CorrelationWindows window_;
    BlockingAccumulator means_;  ///< C, D, the integrals of C cos(w t), and last the change of D at double spacing
    std::vector<Coarse> coarse_;
};

}  // namespace ljmd
