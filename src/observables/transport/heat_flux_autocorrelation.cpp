#include "observables/transport/heat_flux_autocorrelation.hpp"

#include <limits>

#include "ljmd/detail/observables/thermodynamics.hpp"
#include "model/velocities.hpp"
#include "observables/statistics/known_quantities.hpp"
#include "observables/transport/heat_flux.hpp"

namespace ljmd {

HeatFluxAutocorrelation::HeatFluxAutocorrelation(const SampledRun& run, const LagTimes& lags, Index window)
    : potential_(run.interaction.value().potential),
      volume_(run.box.volume()),
      every_(lags.every),
      series_(3, lags, window, 3.0) {}

void HeatFluxAutocorrelation::sample(const State& state, const Evaluation& /*evaluation*/) {
    ++samples_;
    series_.add(heat_flux(state, potential_), temperature(state).value_or(0.0), state.execution());
}

double HeatFluxAutocorrelation::conductivity_per_integral() const {
    const double temperature = series_.averages().temperature();
    return is_above_zero(temperature) ? volume_ / (temperature * temperature)
                                      : std::numeric_limits<double>::quiet_NaN();
}

std::vector<DataTable> HeatFluxAutocorrelation::tables() const {
    if (series_.averages().windows() == 0) {
        return {};
    }
    return {series_.averages().table("heat_flux_autocorrelation", "thermal_conductivity", conductivity_per_integral())};
}

std::vector<ObservableAverage> HeatFluxAutocorrelation::observables() const {
    if (series_.averages().windows() == 0) {
        return {};
    }
    ObservableAverage conductivity =
        series_.averages().coefficient(average_of("thermal_conductivity"), conductivity_per_integral());
    if (conductivity.estimate && !series_.averages().has_levelled_out()) {
        conductivity.estimate.reset();
        conductivity.remark = still_changes;
    }
    return {conductivity};
}

}  // namespace ljmd
