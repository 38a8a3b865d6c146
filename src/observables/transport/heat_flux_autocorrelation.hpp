#pragma once

#include "core/schedule.hpp"
#include "observables/transport/green_kubo_averages.hpp"

namespace ljmd {

/// Autocorrelation of the heat flux J (heat_flux.hpp) and thermal conductivity by the Green-Kubo relation:
///
///     C(t)      = <J(0) . J(t)>/3
///     lambda(t) = V/T^2 integral from 0 to t of C,   lambda = lambda(max_time)
///
/// Averages are over all time origins within windows of twice the largest time; standard errors by block averaging over
/// windows; T is the mean over the sampled configurations. The mean of J is zero, so C needs no subtraction, in any
/// ensemble whose centre of mass rests. A thermostat that scales all velocities alike disturbs the motion of the atoms
/// relative to one another little; others change it (see check_motion() of decks).
/// Table `heat_flux_autocorrelation`: time [tau], heat_flux_autocorrelation [epsilon^2/(sigma^4 tau^2)], its error,
/// thermal_conductivity lambda(t) [k_B/(sigma tau)], its error. Observable: thermal_conductivity. It has no value if
/// configurations are too far apart (see green_kubo.hpp), or if lambda(t) has not levelled out
/// (GreenKuboAverages::has_levelled_out).
/// Source: Green (1954), doi:10.1063/1.1740082; Allen and Tildesley, 2nd ed., section 2.7
class HeatFluxAutocorrelation : public Analysis {
  public:
    /// @param window  configurations per window, greater than lags.count
    /// @pre run.interaction is known
    HeatFluxAutocorrelation(const SampledRun& run, const LagTimes& lags, Index window);

    [[nodiscard]] bool due(Index step) const override { return every_.due(step); }
    void sample(const State& state, const Evaluation& evaluation) override;
    void interrupt() override { series_.interrupt(); }
    [[nodiscard]] Index samples() const override { return samples_; }
    [[nodiscard]] std::vector<DataTable> tables() const override;
    [[nodiscard]] std::vector<ObservableAverage> observables() const override;
    void archive(Archive& a) override { a(samples_, series_); }

  private:
    /// V/T^2; NaN if there is no temperature.
    [[nodiscard]] double conductivity_per_integral() const;

    PairPotential potential_;
    double volume_;
    Every every_;
    Index samples_ = 0;
    GreenKuboSeries series_;
};

}  // namespace ljmd
