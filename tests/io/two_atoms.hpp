#pragma once

#include "ljmd/model/configuration.hpp"

namespace ljmd::test {

/// Two atoms that nothing is wrong with.
inline Configuration two_atoms() {
    Configuration configuration;
    configuration.edges = Vec3(4.0, 5.0, 6.0);
    configuration.positions = {{0.5, 1.0, 1.5}, {3.5, -9.0, 1e6}};
    configuration.velocities = {{0.0, 0.0, 0.0}, {1.0, 2.0, 3.0}};
    configuration.masses = {1.0, 2.0};
    return configuration;
}

}  // namespace ljmd::test
