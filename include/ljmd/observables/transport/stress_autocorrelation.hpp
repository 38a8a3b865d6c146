#pragma once

#include "ljmd/core/schedule.hpp"
#include "ljmd/observables/statistics/blocking.hpp"
#include "ljmd/observables/transport/correlation_windows.hpp"
#include "ljmd/observables/transport/lag_times.hpp"

namespace ljmd {

/// Stress autocorrelation and shear viscosity by Green and Kubo's relation, from all components of the traceless,
/// symmetric part of the stress P, here the mechanical_stress():
///
///     P'_ab  = (P_ab + P_ba)/2 - delta_ab tr P/3
///     C(t)   = <sum_ab P'_ab(0) P'_ab(t)>/10
///     eta(t) = V/T integral from 0 to t of C,   eta = eta(max_time)
///
/// An isotropic fluid has <P_xy(0) P_xy(t)> = C(t); the sum is ten times that. Averages over all time origins within
/// windows of twice the largest time; standard errors by blocking over windows; T is the mean of the sampled
/// configurations. Tail corrections have no part in it.
/// Table `stress_autocorrelation`: time [tau], stress_autocorrelation [epsilon^2/sigma^6], its error, viscosity eta(t)
/// [epsilon tau/sigma^3], its error. Observable: viscosity. Where configurations are too far
/// apart (see green_kubo.hpp) it has no value, nor has eta(t).
/// Source: Daivis and Evans (1994), doi:10.1063/1.466970; Allen and Tildesley, 2nd ed., section 8.4
class StressAutocorrelation : public Analysis {
  public:
    /// @param window  configurations in a window, more than lags.count
    StressAutocorrelation(const Box& box, const LagTimes& lags, Index window);

    [[nodiscard]] bool due(Index step) const override { return every_.due(step); }
    [[nodiscard]] bool needs_energy() const override { return true; }
    void sample(const State& state, const Evaluation& evaluation) override;
    void interrupt() override;
    [[nodiscard]] Index samples() const override { return samples_; }
    [[nodiscard]] std::vector<DataTable> tables() const override;
    [[nodiscard]] std::vector<ObservableAverage> observables() const override;
    void archive(Archive& a) override { a(samples_, window_, in_window_, temperature_sum_, means_); }

  private:
    /// V/T; NaN where there is no temperature.
    [[nodiscard]] double viscosity_per_integral() const;
    [[nodiscard]] Estimate viscosity() const;
    [[nodiscard]] double change_of_viscosity() const;  ///< with every second configuration

    double volume_;
    LagTimes lags_;
    Every every_;
    Index samples_ = 0;
    CorrelationWindows window_;
    Index in_window_ = 0;           ///< configurations in the window that has begun
    double temperature_sum_ = 0.0;  ///< over them
    BlockingAccumulator means_;     ///< C, its integral, T, the change of the integral at twice the spacing
};

}  // namespace ljmd
