#pragma once

#include "forces/made_few_body_force.hpp"

namespace ljmd::test {

/// Three-body problems in the plane with G = 1.

inline State three_bodies(const std::vector<Vec3>& positions, const std::vector<Vec3>& velocities,
                          const std::vector<double>& masses) {
    State state = bodies_at(positions, masses);
    for (std::size_t i = 0; i < velocities.size(); ++i) {
        state.write_velocities().col(static_cast<Index>(i)) = velocities[i];
    }
    return state;
}

/// Three equal masses that follow each other on an eight. Source: Chenciner and Montgomery (2000), doi:10.2307/2661357;
/// numbers by C. Simo, given there.
inline State figure_eight() {
    const Vec3 r(0.97000436, -0.24308753, 0.0);
    const Vec3 v(-0.93240737, -0.86473146, 0.0);
    return three_bodies({r, -r, Vec3::Zero()}, {-0.5 * v, -0.5 * v, v}, {1.0, 1.0, 1.0});
}
constexpr double figure_eight_period = 6.32591398;

/// Masses 3, 4 and 5 at rest at the corners of the triangle with those sides. Source: Burrau (1913),
/// doi:10.1002/asna.19131950602; Szebehely and Peters (1967), doi:10.1086/110355
inline State pythagorean() {
    return three_bodies({{1.0, 3.0, 0.0}, {-2.0, -1.0, 0.0}, {1.0, -1.0, 0.0}}, {}, {3.0, 4.0, 5.0});
}

/// The first 15 numbers of numpy.random.seed(42); numpy.random.rand: x, y, v_x, v_y of three bodies each, then masses.
inline State random_three_bodies() {
    return three_bodies({{0.3745401188473625, 0.5986584841970366, 0.0},
                         {0.9507143064099162, 0.15601864044243652, 0.0},
                         {0.7319939418114051, 0.15599452033620265, 0.0}},
                        {{0.05808361216819946, 0.7080725777960455, 0.0},
                         {0.8661761457749352, 0.020584494295802447, 0.0},
                         {0.6011150117432088, 0.9699098521619943, 0.0}},
                        {0.8324426408004217, 0.21233911067827616, 0.18182496720710062});
}

}  // namespace ljmd::test
