#pragma once

#include <optional>

#include "ljmd/detail/model/state.hpp"

namespace ljmd::test {

/// Three atoms, in memory in the order 2, 0, 1. The second has left the box.
inline State three_atoms(const std::optional<Box>& box = Box(Vec3(4.0, 5.0, 6.5))) {
    State state(3, box);
    state.write_positions().col(0) = Vec3(0.5, 1.0, 1.5);
    state.write_positions().col(1) = Vec3(-1.25, 5.5, 13.75);
    state.write_positions().col(2) = Vec3(3.0, 3.25, 3.5);
    state.write_velocities().col(0) = Vec3(1.0, 0.0, -1.0);
    state.write_velocities().col(1) = Vec3(0.1, 0.2, 0.3);
    state.write_velocities().col(2) = Vec3(1e-5, -2.5e10, 0.0);
    if (box) {
        state.wrap();
    }
    state.reorder({2, 0, 1});
    state.time = 0.3;
    state.step = 75;
    return state;
}

}  // namespace ljmd::test
