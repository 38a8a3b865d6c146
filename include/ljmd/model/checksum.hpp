#pragma once

#include <string>

#include "ljmd/model/state.hpp"

namespace ljmd {

/// A fingerprint of all positions, to the last bit: XXH3 (64 bits) of the coordinates, in a periodic box brought inside
/// it, with the number of edges crossed, in the order of ids. Equal for states that differ only in the order of atoms
/// in memory or in when they were last wrapped.
/// @throws PhysicsError when a position is not finite
[[nodiscard]] std::string checksum(const State& state);

}  // namespace ljmd
