#pragma once

#include <string>

#include "ljmd/reference/phase_equilibrium.hpp"

namespace ljmd {

// Reports of `ljmd eos` as a table or as JSON. In reduced units, energies per atom.

/// All equations of state: source, range, critical point.
[[nodiscard]] std::string equations_table();
[[nodiscard]] std::string equations_json();

/// One state of the fluid.
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
