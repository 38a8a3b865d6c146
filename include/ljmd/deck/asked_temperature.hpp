#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ljmd/deck/deck.hpp"
#include "ljmd/observables/statistics/run_averages.hpp"
#include "ljmd/reference/equation_of_state.hpp"

namespace ljmd {

/// The temperature that a deck of a fluid asks for where it samples: that of the thermostat there, else of the last one
/// before, else that of [system]. Nothing where it asks for none, or for several.
[[nodiscard]] std::optional<double> asked_temperature(const Deck& deck);

/// What is to be said where the temperature of a run is off the one that its deck asks for by more than three standard
/// errors; empty where it is not.
/// @param found  over the sampled stages
[[nodiscard]] std::string temperature_remark(const Deck& deck, const std::optional<Estimate>& found);

/// The equation of state of the very fluid that a deck simulates; nothing where there is none. The full Lennard-Jones
/// fluid is one that is cut at 2.5 sigma or farther out, with tail corrections.
[[nodiscard]] std::optional<EquationOfState> equation_of_fluid(const Deck& deck);

/// What a run at constant energy has at the temperature that its deck asks for.
struct AtAskedTemperature {
    double temperature;
    std::string equation;                        ///< of state, by whose slopes
    std::vector<ObservableAverage> observables;  ///< potential_energy, pressure, compressibility_factor
};

/// Nothing where the temperature that was found is the one that was asked for (see temperature_remark()), farther off
/// it than a tenth, or held by a thermostat; where there is no equation of state of the fluid, or where this one is
/// outside of its range or describes no stable phase.
/// @param averages  not empty
[[nodiscard]] std::optional<AtAskedTemperature> at_asked_temperature(const Deck& deck, double density,
                                                                     const RunAverages& averages);

}  // namespace ljmd
