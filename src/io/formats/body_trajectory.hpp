#pragma once

#include <filesystem>

#include "ljmd/detail/observables/analysis.hpp"

namespace ljmd {

/// The trajectory of a few-body run in extended XYZ or H5MD as a table with the columns of trajectory.csv: step, time,
/// then for each body x1, y1, z1 and, where the file has them, vx1, vy1, vz1. These files always have three
/// coordinates: those that are 0 in every frame are left out, from the last on. A frame that is being written is
/// ignored.
///
/// `TrajectoryReader` reads fluids: it refuses unbounded space and bodies of several masses.
/// @throws DataError  the file cannot be read, or is damaged before its last frame
[[nodiscard]] DataTable read_body_trajectory(const std::filesystem::path& path);

}  // namespace ljmd
