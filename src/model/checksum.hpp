#pragma once

#include <string>

#include "ljmd/detail/model/state.hpp"
#include "ljmd/model/configuration.hpp"

namespace ljmd {

/// Checksum of all positions, to the last bit: XXH3 (64 bits) of the coordinates in the order of ids; in a periodic
/// box, of the wrapped coordinates and the number of edges crossed. It does not depend on the order of atoms in memory,
/// nor on when they were last wrapped.
/// @throws PhysicsError if a position is not finite
[[nodiscard]] std::string checksum(const State& state);

/// Checksum of all that was read of a configuration, to the last bit.
[[nodiscard]] std::string checksum(const Configuration& configuration);

}  // namespace ljmd
