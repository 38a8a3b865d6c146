#pragma once

#include "ljmd/model/state.hpp"

namespace ljmd {

// Totals of a system without a box. Kinetic energy and momentum are in model/velocities.hpp.

/// Total angular momentum about the origin, sum m r x v. @pre the state has no box, whose images do not conserve it
[[nodiscard]] Vec3 angular_momentum(const State& state);

/// Centre of mass, sum m r / sum m. @pre the state has no box; the masses do not sum to zero
[[nodiscard]] Vec3 centre_of_mass(const State& state);

}  // namespace ljmd
