#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ljmd/core/types.hpp"

namespace ljmd {

/// A configuration as it stands in a file, before it becomes a State: atoms in the order of their ids, all numbers
/// checked to be finite, units already reduced.
struct Configuration {
    Vec3 edges = Vec3::Zero();     ///< box edges [sigma]
    std::vector<Vec3> positions;   ///< [sigma], as given: possibly outside the box
    std::vector<Vec3> velocities;  ///< [sigma/tau], empty when the file has none
    std::vector<double> masses;    ///< [m], empty when the file has none
    double time = 0.0;             ///< [tau]
    Index step = 0;
};

}  // namespace ljmd
