#pragma once

#include "ljmd/model/state.hpp"

namespace ljmd {

// Totals of a system without a box. Kinetic energy and momentum stand in model/velocities.hpp.

/// Total angular momentum about the origin, sum m r x v. @pre the state has no box: images would not conserve it
[[nodiscard]] Vec3 angular_momentum(const State& state);

/// Centre of mass, sum m r / sum m. @pre the state has no box, and masses that do not sum to zero
[[nodiscard]] Vec3 centre_of_mass(const State& state);

}  // namespace ljmd
