#pragma once

#include "ljmd/core/document.hpp"
#include "ljmd/reference/phase_equilibrium.hpp"

namespace ljmd {

// Reports on equations of state, as `ljmd eos` prints them. In reduced units, energies per atom.

/// All equations of state: source, range, critical point.
[[nodiscard]] Document equations_document();

/// One state of the fluid.
/// @param temperature  > 0
/// @param density      >= 0
/// @throws PhysicsError where the equation gives no pressure
[[nodiscard]] Document state_document(const EquationOfState& equation, double temperature, double density);

/// Liquid and vapour at coexistence.
/// @throws InputError at and above the critical temperature
[[nodiscard]] Document coexistence_document(const EquationOfState& equation, double temperature);

}  // namespace ljmd
