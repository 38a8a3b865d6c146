#pragma once

#include <string>

#include "ljmd/reference/phase_equilibrium.hpp"

namespace ljmd {

// What an equation of state says, as `ljmd eos` prints it: for people, or as JSON. In reduced units, energies per atom.

/// All equations of state: whose, where they hold, critical point.
[[nodiscard]] std::string equations_table();
[[nodiscard]] std::string equations_json();

/// One state.
/// @param temperature  > 0
/// @param density      >= 0
/// @throws PhysicsError where the equation gives no pressure
[[nodiscard]] std::string state_table(const EquationOfState& equation, double temperature, double density);
[[nodiscard]] std::string state_json(const EquationOfState& equation, double temperature, double density);

/// Liquid and vapour at coexistence.
/// @throws InputError at and above the critical temperature
[[nodiscard]] std::string coexistence_table(const EquationOfState& equation, double temperature);
[[nodiscard]] std::string coexistence_json(const EquationOfState& equation, double temperature);

}  // namespace ljmd
