#pragma once

#include "ljmd/detail/core/data.hpp"

namespace ljmd {

/// The lines of the phase diagram of the Lennard-Jones fluid, by temperature: binodal and spinodals by Thol's equation
/// of state, freezing and melting, as tables of the page. Its critical and triple point.
[[nodiscard]] Data phase_diagram();

/// Pressure and energy of the fluid by Thol's equation.
[[nodiscard]] Data equation_at(double temperature, double density);

/// The same, with what is stable in the state and the lines around it in words; `fluid`: the equation of state is that
/// of its phase. Takes a thousand times as long.
[[nodiscard]] Data state_of_fluid(double temperature, double density);

}  // namespace ljmd
