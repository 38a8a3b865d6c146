#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/io/trajectory_reader.hpp"

namespace ljmd {

/// What a trajectory holds, its positions aside.
struct TrajectorySummary {
    Index frames;
    Index atoms;
    Vec3 edges;                        ///< of the box of the first frame [sigma]
    Vec3 smallest_edges;               ///< of all frames, edge by edge [sigma]
    std::optional<Index> box_changes;  ///< the frame, from 1, whose box is another one than that of the first
    bool has_velocities;
    std::vector<Index> steps;   ///< of the frames; empty where not all have one
    std::vector<double> times;  ///< [tau], likewise
    bool wrapped;               ///< atoms that leave the box come in again on its other side
    std::string warning;        ///< of the reader; may be empty
};

/// Read all of a trajectory once. Where the file does not tell whether its positions are wrapped, they are taken to be
/// unless they spread over more than an edge of the box (and a twentieth, as some programs wrap late).
/// @throws DataError as TrajectoryReader::next, and for a file without frames
[[nodiscard]] TrajectorySummary summarize(const std::filesystem::path& path,
                                          const std::optional<SubstanceUnits>& units);

}  // namespace ljmd
