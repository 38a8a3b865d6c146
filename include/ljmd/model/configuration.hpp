#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ljmd/core/types.hpp"

namespace ljmd {

/// A configuration read from a file, before it becomes a State: atoms in the order of their ids, numbers checked to be
/// finite, in reduced units.
struct Configuration {
    Vec3 edges = Vec3::Zero();              ///< box edges [sigma]
    std::vector<Vec3> positions = {};       ///< [sigma], as in the file; may lie outside the box
    std::vector<Vec3> velocities = {};      ///< [sigma/tau]; empty if the file has none
    std::vector<double> masses = {};        ///< [m]; empty if the file has none
    std::optional<double> time = {};        ///< [tau]; none if the file has none
    std::optional<Index> step = {};         ///< none if the file has none
    bool is_unwrapped = false;              ///< known: the file says so, or image flags were applied; else unknown
    std::vector<std::string> remarks = {};  ///< on what the file has and nobody takes
};

}  // namespace ljmd
