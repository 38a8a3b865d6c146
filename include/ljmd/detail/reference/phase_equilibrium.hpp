#pragma once

#include <optional>

#include "ljmd/detail/reference/equation_of_state.hpp"

namespace ljmd {

/// Critical point: dp/drho = d2p/drho2 = 0. In reduced units.
struct CriticalPoint {
    double temperature;
    double density;
    double pressure;
};

/// The critical point of an equation of state, from its exact derivatives. It is the highest temperature at which the
/// smallest slope dp/drho of an isotherm, where d2p/drho2 = 0, is zero.
[[nodiscard]] CriticalPoint critical_point(const EquationOfState& equation);

/// G/N = mu up to a function of the temperature: T ln rho + mu_x. @pre density > 0
[[nodiscard]] double chemical_potential(const FluidProperties& phase);

/// The phase with this pressure between two densities where dp/drho >= 0. If the pressure is not between the pressures
/// of the ends, as happens by round-off at the spinodals, the nearer end.
[[nodiscard]] FluidProperties phase_at(const EquationOfState& equation, double temperature, double pressure,
                                       double thin, double dense);

/// Where vapour and liquid cease to be stable or metastable: dp/drho = 0. Densities [sigma^-3].
struct Spinodals {
    double vapour;
    double liquid;
};

/// The spinodals of an isotherm; empty at and above the critical temperature.
/// @pre temperature > 0
/// @throws PhysicsError if the equation has no stable liquid or vapour: far below the triple point
[[nodiscard]] std::optional<Spinodals> spinodals(const EquationOfState& equation, double temperature);

/// Liquid and vapour in equilibrium: equal temperature, pressure and chemical potential.
struct Coexistence {
    double pressure;
    FluidProperties liquid;
    FluidProperties vapour;

    /// Enthalpy of vaporisation per atom: u_v - u_l + p (1/rho_v - 1/rho_l).
    [[nodiscard]] double heat_of_vaporisation() const;
};

/// Coexistence at a temperature: the root of mu_liquid(p) - mu_vapour(p) between the pressures at the spinodals. Empty
/// at and above the critical temperature, and so near below it that rounding hides the difference of the phases: from
/// 1 - T/T_c = 1e-12 on they have two digits of it and more (johnson1993, which rounds more: from 3e-10 on).
/// @pre temperature > 0
/// @throws PhysicsError if the equation has no coexistence: far below the triple point
[[nodiscard]] std::optional<Coexistence> coexistence(const EquationOfState& equation, double temperature);

}  // namespace ljmd
