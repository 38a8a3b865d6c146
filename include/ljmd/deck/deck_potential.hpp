#pragma once

#include "ljmd/core/section.hpp"
#include "ljmd/potentials/pair_potential.hpp"

namespace ljmd {

/// The potential of a deck. @param potential  [potential], validated with the keys of its type and truncation
/// @pre cutoff > 0; for `switched` 0 < switch_start < cutoff
[[nodiscard]] PairPotential pair_potential_of(const Section& potential);

}  // namespace ljmd
