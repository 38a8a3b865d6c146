#pragma once

#include <string>
#include <vector>

#include "ljmd/reference/equation_of_state.hpp"

namespace ljmd {

/// Why the numbers are not to be relied upon; empty when they are: beyond what the equation was fitted to; between the
/// densities of liquid and vapour, where the fluid separates; above the density at which the full Lennard-Jones fluid
/// freezes, between the triple point and the highest temperature of freezing_densities().
[[nodiscard]] std::vector<std::string> doubts(const EquationOfState& equation, double temperature, double density);

}  // namespace ljmd
