#pragma once

#include "ljmd/model/box.hpp"

namespace ljmd {

/// The box itself, or, if an edge is shorter than twice the cutoff by at most 1e-12 of it, the box with that edge
/// lengthened to twice the cutoff. So half an edge is a valid cutoff, although the edge may have been rounded: computed
/// from bounds, converted from other units, or put on the grid of the box.
/// @param cutoff  [sigma], finite and positive
[[nodiscard]] Box box_for_cutoff(const Box& box, double cutoff);

}  // namespace ljmd
