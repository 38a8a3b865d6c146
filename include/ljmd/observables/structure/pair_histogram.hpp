#pragma once

#include <vector>

#include "ljmd/model/state.hpp"

namespace ljmd {

/// Counts the pairs of atoms by their distance: counts[k] is the number of pairs {i, j} with k w <= r_ij < (k + 1) w,
/// w = radius/bins, r_ij the distance of the nearest images.
///
/// Atoms are sorted into cells of half the radius; each meets those that follow it in this order, in the cells around.
/// Time O(atoms * neighbours); where cells are few, each pair is met once. Any number of threads counts the same.
/// @param state   has a box; is not changed
/// @param radius  > 0 and at most half the shortest edge
/// @param bins    at least 1
[[nodiscard]] std::vector<Index> pair_histogram(const State& state, double radius, Index bins);

}  // namespace ljmd
