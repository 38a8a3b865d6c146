#pragma once

#include "core/schedule.hpp"
#include "observables/transport/green_kubo_averages.hpp"

namespace ljmd {

/// Autocorrelation of the pressure at constant energy and bulk viscosity by the Green-Kubo relation. With
/// p = tr mechanical_stress()/3 and its mean at the energy of the stage:
///
///     C(t)      = <dp(0) dp(t)>,   dp = p - <p>
///     eta_v(t)  = V/T integral from 0 to t of C,   eta_v = eta_v(max_time)
///
/// Only stages without thermostat count. In the canonical ensemble dp contains (dp/dE)_V dE, and E fluctuates as slowly
/// as the thermostat lets it: the integral would measure the thermostat.
///
/// The mean is not known but as the stage's, p_s, so each stage has its own. It lies closer to the stage's
/// pressures than <p> does, which lowers the correlation at all times by the variance of p_s, 2/T_s integral of C in a
/// stage of length T_s. This is corrected, window by window, with I the integral up to max_time of p - p_s:
///
///     C(t) = <(p - p_s)(0) (p - p_s)(t)> + 2/T_s I/(1 - 2 max_time/T_s)
///
/// Stages shorter than ten times max_time are left out. The pressures of all samples are kept, 8 bytes each.
///
/// Table `pressure_autocorrelation`: time [tau], pressure_autocorrelation [epsilon^2/sigma^6], its error,
/// bulk_viscosity eta_v(t) [epsilon tau/sigma^3], its error. Observable: bulk_viscosity. It has no value if
/// configurations are too far apart (see green_kubo.hpp), or if eta_v(t) has not levelled out
/// (GreenKuboAverages::has_levelled_out). Source: Hansen and McDonald, Theory of simple liquids, 4th ed., section 8.5;
/// Meier, Laesecke and Kabelac (2005), doi:10.1063/1.1828040
class PressureAutocorrelation : public Analysis {
  public:
    /// Shortest stage that counts, in multiples of the largest time.
    static constexpr Index shortest_stage = 10;

    /// @param window  configurations per window, greater than lags.count
    PressureAutocorrelation(const Box& box, const LagTimes& lags, Index window);

    [[nodiscard]] bool due(Index step) const override { return every_.due(step); }
    [[nodiscard]] bool needs_energy() const override { return true; }
    void sample(const State& state, const Evaluation& evaluation) override;
    void interrupt() override;
    [[nodiscard]] Index samples() const override { return samples_; }
    [[nodiscard]] std::vector<DataTable> tables() const override;
    [[nodiscard]] std::vector<ObservableAverage> observables() const override;
    void archive(Archive& a) override { a(samples_, temperature_sum_, stages_); }

  private:
    /// V/T; NaN if there is no temperature.
    [[nodiscard]] double viscosity_per_integral() const;
    [[nodiscard]] GreenKuboAverages averages() const;
    void add_windows(const std::vector<double>& pressures, GreenKuboAverages& averages) const;

    double volume_;
    LagTimes lags_;
    Index window_;
    Every every_;
    Index samples_ = 0;
    double temperature_sum_ = 0.0;
    std::vector<std::vector<double>> stages_;  ///< pressures without interruption
};

}  // namespace ljmd
