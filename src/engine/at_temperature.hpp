#pragma once

#include <functional>

#include "ljmd/core/types.hpp"
#include "ljmd/detail/reference/equation_of_state.hpp"
#include "ljmd/observables/statistics/blocking.hpp"

namespace ljmd {

/// Properties of a fluid at a temperature other than the measured one.
struct AtTemperature {
    Estimate potential_energy;        ///< U/N [epsilon]
    Estimate pressure;                ///< p [epsilon/sigma^3]
    Estimate compressibility_factor;  ///< Z
};

/// Means of temperature, potential energy per atom and pressure, in this order.
using MeansOfState = Vec3;

/// Estimate of a value computed from such means; the gradient is the value's with respect to them.
using EstimateFromMeans = std::function<Estimate(double value, const Vec3& gradient)>;

/// Convert means from the measured temperature T to another one, T_0, with an equation of state of the same fluid:
///
///     Z(T_0) = <p>/(rho <T>) + Z_m(T_0) - Z_m(<T>),    U(T_0) = <u> + U_m(T_0) - U_m(<T>),    p(T_0) = rho T_0 Z(T_0)
///
/// The errors follow from the errors of the three series together (delta method): at constant energy they fluctuate
/// together, and the part that fluctuations of T explain is no error at a given T. The error of the equation of state
/// in the difference is not included; it vanishes with T_0 - <T>.
/// @pre density > 0, <T> > 0, T_0 > 0
[[nodiscard]] AtTemperature at_temperature(const EquationOfState& equation, double density, double temperature,
                                           const MeansOfState& means, const EstimateFromMeans& estimate);

}  // namespace ljmd
