#pragma once

#include <string>

#include "ljmd/detail/options/units.hpp"

namespace ljmd {

/// Why the text of an option is not a number in reduced units; empty when it is. For a quantity with a unit the message
/// also gives its value in reduced units of argon.
/// @param unit  the reduced unit, for the message: "epsilon/k_B"
[[nodiscard]] std::string not_reduced(const std::string& text, const std::string& unit, Dimension dimension);

}  // namespace ljmd
