#pragma once

#include "ljmd/detail/model/state.hpp"

namespace ljmd {

/// The pairs of a configuration that are nearer than a distance.
struct NearPairs {
    Index count = 0;
    double nearest = 0.0;  ///< distance of the nearest pair [sigma]; meaningless without a pair
    Index first = 0;       ///< id of an atom of the nearest pair
    Index second = 0;      ///< id of the other one, which may be an image of the first
};

/// Neither the order of atoms in memory nor the number of threads changes what is found.
/// @param distance  [sigma], > 0, at most half the shortest edge of the box (checked: ContractViolation)
[[nodiscard]] NearPairs pairs_nearer_than(const State& state, double distance);

}  // namespace ljmd
