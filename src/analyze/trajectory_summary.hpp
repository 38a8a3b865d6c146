#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analyze/position_reading.hpp"
#include "io/formats/trajectory_reader.hpp"

namespace ljmd {

/// Called after each frame that is read; what it throws ends the reading.
using FrameRead = std::function<void()>;

/// Contents of a trajectory, without its positions.
struct TrajectorySummary {
    Index frames;
    Index atoms;
    bool is_part = false;              ///< the ids have gaps, or do not begin at 0 or 1: there are other atoms
    Vec3 edges;                        ///< of the box of the first frame [sigma]
    Vec3 smallest_edges;               ///< smallest edges over all frames, per axis [sigma]
    std::optional<Index> box_changes;  ///< the first frame, from 1, whose box differs from frame 1's
    bool has_velocities;               ///< true if all frames have velocities
    std::string missing_velocities;    ///< why not: "which the trajectory does not have"
    std::vector<Index> steps;          ///< of the frames; empty if they have none
    std::vector<double> times;         ///< [tau], likewise
    FrameMotion motion;
    PositionReading positions;
    std::vector<std::size_t> breaks;    ///< frames, from 0, that do not continue the one before
    std::vector<std::string> warnings;  ///< from the reader
};

/// Read a whole trajectory once.
/// @param group      particle group, see open_trajectory()
/// @param positions  the user's choice
/// @throws DataError as TrajectoryReader::next, and for a file without frames
[[nodiscard]] TrajectorySummary summarize(const std::filesystem::path& path, const std::optional<SubstanceUnits>& units,
                                          const std::string& group = {},
                                          std::optional<Positions> positions = std::nullopt,
                                          const std::string& xyz_comment = {}, const FrameRead& frame_read = {});

}  // namespace ljmd
