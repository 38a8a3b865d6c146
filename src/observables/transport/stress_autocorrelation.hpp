#pragma once

#include "core/schedule.hpp"
#include "observables/transport/green_kubo_averages.hpp"

namespace ljmd {

/// Stress autocorrelation and shear viscosity by the Green-Kubo relation, from all components of the traceless
/// symmetric part of the stress P = mechanical_stress():
///
///     P'_ab  = (P_ab + P_ba)/2 - delta_ab tr P/3
///     C(t)   = <sum_ab P'_ab(0) P'_ab(t)>/10
///     eta(t) = V/T integral from 0 to t of C,   eta = eta(max_time)
///
/// In an isotropic fluid <P_xy(0) P_xy(t)> = C(t), and the sum is ten times that. Averages are over all time origins
/// within windows of twice the largest time; standard errors by block averaging over windows; T is the mean over the
/// sampled configurations. Tail corrections do not contribute.
/// Table `stress_autocorrelation`: time [tau], stress_autocorrelation [epsilon^2/sigma^6], its error, viscosity eta(t)
/// [epsilon tau/sigma^3], its error. Observable: viscosity. If configurations are too far apart (see green_kubo.hpp),
/// neither viscosity nor eta(t) has a value.
/// Source: Daivis and Evans (1994), doi:10.1063/1.466970; Allen and Tildesley, 2nd ed., section 8.4
class StressAutocorrelation : public Analysis {
  public:
    /// @param window  configurations per window, greater than lags.count
    StressAutocorrelation(const Box& box, const LagTimes& lags, Index window);

    [[nodiscard]] bool due(Index step) const override { return every_.due(step); }
    [[nodiscard]] bool needs_energy() const override { return true; }
    void sample(const State& state, const Evaluation& evaluation) override;
    void interrupt() override { series_.interrupt(); }
    [[nodiscard]] Index samples() const override { return samples_; }
    [[nodiscard]] std::vector<DataTable> tables() const override;
    [[nodiscard]] std::vector<ObservableAverage> observables() const override;
    void archive(Archive& a) override { a(samples_, series_); }

  private:
    /// V/T; NaN if there is no temperature.
    [[nodiscard]] double viscosity_per_integral() const;

    double volume_;
    Every every_;
    Index samples_ = 0;
    GreenKuboSeries series_;
};

}  // namespace ljmd
