#pragma once

#include "ljmd/model/box.hpp"

namespace ljmd {

/// The box itself; or, where rounding has left an edge shorter than twice the cutoff, by 1e-12 of it at most, the box
/// with that edge twice the cutoff. So a cutoff that is typed as half an edge is legal, although the edge is a
/// difference of bounds, is converted from other units or was rounded to the grid of the box.
/// @param cutoff  [sigma], finite and positive
[[nodiscard]] Box box_for_cutoff(const Box& box, double cutoff);

}  // namespace ljmd
