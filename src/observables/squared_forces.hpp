#pragma once

#include "ljmd/detail/model/state.hpp"

namespace ljmd {

/// sum over atoms of f^2/m [epsilon/tau^2]; with masses of 1 it is |grad U|^2. @pre the forces are current
[[nodiscard]] double squared_forces_over_mass(const State& state);

}  // namespace ljmd
