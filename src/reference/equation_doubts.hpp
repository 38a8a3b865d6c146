#pragma once

#include <string>
#include <vector>

#include "ljmd/detail/reference/equation_of_state.hpp"

namespace ljmd {

/// Why the results of an equation are unreliable at a state; empty if they are reliable. Reasons are: outside of the
/// range of the fit; between the densities of liquid and vapour, where the fluid separates; above the freezing density
/// of the full Lennard-Jones fluid, for the temperatures of freezing_densities().
[[nodiscard]] std::vector<std::string> doubts(const EquationOfState& equation, double temperature, double density);

}  // namespace ljmd
