#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ljmd/core/types.hpp"

namespace ljmd {

/// What forces that do not sum to zero, as forces of pairs must, tell of an engine; nothing if they do, or if their sum
/// is no larger than rounding errors make it:
///
///     constant force   F'_i = F_i + c, the same vector c for every atom: an external field
///     net force        |sum F'_i| is more than rounding leaves: a field that differs from place to place, or pairs
///                      that act on one of their two atoms only
///
/// @param found  the engine's forces F' [epsilon/sigma]
/// @param right  ours, F, of the same atoms
/// @param noise  differences between the two that are none, as the root of their summed squares [epsilon/sigma]
/// @pre  the two have the same size, above 0
[[nodiscard]] std::optional<std::string> net_force(const std::vector<Vec3>& found, const std::vector<Vec3>& right,
                                                   double noise);

}  // namespace ljmd
