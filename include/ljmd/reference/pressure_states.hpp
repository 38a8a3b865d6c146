#pragma once

#include <vector>

#include "ljmd/detail/reference/phase_equilibrium.hpp"

namespace ljmd {

// States of an equation of state that are given by a pressure instead of a density. In reduced units.

/// A phase at a temperature and a pressure.
struct PhaseAtPressure {
    const char* name;  ///< "liquid", "vapour"; "fluid" at and above the critical temperature
    FluidProperties state;

    /// G/N minus the value of the most stable phase there: mu = T ln rho + mu_x + f(T). Zero for the stable phase,
    /// positive for a metastable one.
    double gibbs_energy_difference;
};

/// The phases with this temperature and pressure that are stable or metastable (dp/drho > 0), the stable one first:
/// below the critical temperature vapour and liquid where the pressure lies between the spinodals' pressures. Between
/// the spinodals themselves, where formulas with many terms have further solutions, there is no phase. Crystals are not
/// considered.
/// @pre temperature > 0, pressure > 0
/// @throws PhysicsError  the equation reaches no such pressure, or has no stable liquid or vapour at the temperature
[[nodiscard]] std::vector<PhaseAtPressure> states_at_pressure(const EquationOfState& equation, double temperature,
                                                              double pressure);

/// Coexistence at a pressure: the temperature at which the vapour pressure is that.
/// @pre pressure > 0
/// @throws InputError  the pressure is not below the critical one
/// @throws PhysicsError  it is lower than all vapour pressures of the equation
[[nodiscard]] Coexistence coexistence_at_pressure(const EquationOfState& equation, double pressure);

}  // namespace ljmd
