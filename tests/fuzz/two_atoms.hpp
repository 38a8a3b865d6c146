#pragma once

#include "ljmd/detail/model/state.hpp"

namespace ljmd::fuzz {

/// Whose trajectory is continued.
inline State two_atoms() {
    constexpr double edge = 4.0;
    State state(2, Box(Vec3::Constant(edge)));
    state.write_positions().col(1).setConstant(1.0);
    return state;
}

}  // namespace ljmd::fuzz
