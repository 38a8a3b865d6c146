#pragma once

#include <string>

#include "ljmd/core/units.hpp"

namespace ljmd {

/// Why the text of an option is no number in reduced units; empty when it is one. A quantity with a unit is told in
/// reduced units of argon.
/// @param unit  reduced, for the message: "epsilon/k_B"
[[nodiscard]] std::string not_reduced(const std::string& text, const std::string& unit, Dimension dimension);

}  // namespace ljmd
