#pragma once

#include <string>

#include "compare/fluid.hpp"
#include "potentials/made_potential.hpp"

namespace ljmd::test {

/// Three atoms in a box of edges 6, 7, 8 with numbers of all digits. The second and third interact through a
/// wall, the first and second within the range of a switch.
inline Fluid small_fluid(const std::string& formula = "lennard-jones", const std::string& truncation = "cut",
                         bool tail = false) {
    Fluid fluid{Vec3(6.0, 7.0, 8.0),
                made_potential(formula, truncation, {2.5, 2.0}),
                tail,
                {1.0, 1.0, 1.0},
                {Vec3(1.0, 1.0 / 3.0, 1.9), Vec3(1.1, 1.7, 0.1), Vec3(1.2, 1.9, 7.123456789012345)},
                {Vec3(0.1, 0.0, -1e-300), Vec3(-0.2, 1.0 / 7.0, -3.0), Vec3(0.0, -0.25, 2.0)}};
    const State state = state_of(fluid);  // on the grid of the box
    return fluid_of(state, fluid.potential, tail);
}

}  // namespace ljmd::test
