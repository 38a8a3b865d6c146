#pragma once

#include <string>

#include "ljmd/potentials/pair_potential.hpp"

namespace ljmd {

/// What tells a potential from others, as text. A formula of the calling program is told by some of its values.
[[nodiscard]] std::string identity(const PairPotential& potential);

}  // namespace ljmd
