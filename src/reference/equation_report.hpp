#pragma once

#include <vector>

#include "core/document.hpp"
#include "ljmd/reference/pressure_states.hpp"

namespace ljmd {

// Reports on equations of state, as `ljmd eos` prints them. In reduced units, energies per atom.

/// All equations of state: source, range, critical point.
[[nodiscard]] Document equations_document();

/// One state of the fluid.
/// @param temperature  > 0
/// @param density      >= 0
/// @throws PhysicsError where the equation gives no pressure
[[nodiscard]] Document state_document(const EquationOfState& equation, double temperature, double density);

/// The most stable state with a pressure; its data also have `phase`, and `metastable`, a list of the other phases with
/// `phase`, `gibbs_energy_difference` and all properties.
/// @param temperature  > 0
/// @param pressure     > 0
/// @throws PhysicsError as states_at_pressure()
[[nodiscard]] Document pressure_document(const EquationOfState& equation, double temperature, double pressure);

/// Liquid and vapour at coexistence.
/// @throws InputError at and above the critical temperature
[[nodiscard]] Document coexistence_document(const EquationOfState& equation, double temperature);

/// The same at the temperature with this vapour pressure. @pre pressure > 0
/// @throws InputError at and above the critical pressure  @throws PhysicsError below all vapour pressures
[[nodiscard]] Document saturation_document(const EquationOfState& equation, double pressure);

/// Points for a table: temperatures with densities, temperatures with pressures, or temperatures or pressures alone,
/// for coexistence. Combinations have the temperature as the slowest.
struct EquationPoints {
    std::vector<double> temperatures{};
    std::vector<double> densities{};
    std::vector<double> pressures{};
};

/// A table of many points. Data: model, source, and `points`: each with the data of its own document above, and with
/// `failure`, the reason for a point that has no values, else null. Text: main columns, and remarks below.
/// @pre not both densities and pressures, and no densities without temperatures
[[nodiscard]] Document points_document(const EquationOfState& equation, const EquationPoints& wanted);

}  // namespace ljmd
