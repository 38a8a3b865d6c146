#pragma once

#include <vector>

#include "ljmd/detail/model/state.hpp"

namespace ljmd {

/// Histogram of pair distances: counts[k] is the number of pairs {i, j} with k w <= r_ij < (k + 1) w, where w =
/// radius/bins and r_ij is the distance of the nearest images.
///
/// Atoms are sorted into cells of half the radius, and each atom meets those that follow it in the cells around. Time
/// O(atoms * neighbours). With few cells, too, each pair is met once. The counts do not depend on the number of
/// threads.
/// @param state   must have a box; is not changed
/// @param radius  > 0; beyond half the shortest edge not every image is counted
/// @param bins    at least 1
[[nodiscard]] std::vector<Index> pair_histogram(const State& state, double radius, Index bins);

}  // namespace ljmd
