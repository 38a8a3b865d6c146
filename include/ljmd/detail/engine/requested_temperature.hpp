#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ljmd/detail/observables/statistics/run_averages.hpp"
#include "ljmd/detail/reference/equation_of_state.hpp"
#include "ljmd/engine/fluid_spec.hpp"

namespace ljmd {

/// The temperature requested for the sampled stages of a run: their thermostat's, else of the last
/// thermostat before them, else of the start. Nothing if none is requested, or several.
[[nodiscard]] std::optional<double> requested_temperature(const FluidSpec& spec);

/// A remark if the temperature of a run differs from the requested one by more than three standard errors;
/// else empty.
/// @param found  mean over the sampled stages
[[nodiscard]] std::string temperature_remark(const FluidSpec& spec, const std::optional<Estimate>& found);

/// The equation of state of exactly the fluid that is simulated; nothing if there is none. Cut at 2.5 sigma or
/// farther out and with tail corrections, a fluid counts as the full Lennard-Jones fluid. A film has none.
[[nodiscard]] std::optional<EquationOfState> equation_of_fluid(const FluidSpec& spec);

/// Results of a run at constant energy, converted to the requested temperature.
struct AtRequestedTemperature {
    double temperature;
    std::string equation;                        ///< equation of state that was used
    std::vector<ObservableAverage> observables;  ///< potential_energy, pressure, compressibility_factor
};

/// Convert the averages of a run. Nothing if the measured temperature agrees with the requested one (see
/// temperature_remark()), differs from it by more than a tenth, or is held by a thermostat; if the fluid has no
/// equation of state; or if the state is outside its range or describes no stable phase.
/// @param averages  not empty
[[nodiscard]] std::optional<AtRequestedTemperature> at_requested_temperature(const FluidSpec& spec, double density,
                                                                             const RunAverages& averages);

}  // namespace ljmd
