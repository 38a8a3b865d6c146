#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/analyze/position_reading.hpp"
#include "ljmd/io/formats/trajectory_reader.hpp"

namespace ljmd {

/// What a trajectory holds, its positions aside.
struct TrajectorySummary {
    Index frames;
    Index atoms;
    Vec3 edges;                        ///< of the box of the first frame [sigma]
    Vec3 smallest_edges;               ///< of all frames, edge by edge [sigma]
    std::optional<Index> box_changes;  ///< the frame, from 1, whose box is another one than that of the first
    bool has_velocities;               ///< all frames have
    std::string missing_velocities;    ///< why not: "which the trajectory does not have"
    std::vector<Index> steps;          ///< of the frames; empty where they have none
    std::vector<double> times;         ///< [tau], likewise
    FrameMotion motion;
    PositionReading positions;
    std::vector<std::size_t> breaks;    ///< frames, from 0, that do not go on from the one before
    std::vector<std::string> warnings;  ///< of the reader
};

/// Read all of a trajectory once.
/// @param group      of particles, see open_trajectory()
/// @param positions  what the user says of them
/// @throws DataError as TrajectoryReader::next, and for a file without frames
[[nodiscard]] TrajectorySummary summarize(const std::filesystem::path& path, const std::optional<SubstanceUnits>& units,
                                          const std::string& group = {},
                                          std::optional<Positions> positions = std::nullopt,
                                          const std::string& xyz_comment = {});

}  // namespace ljmd
