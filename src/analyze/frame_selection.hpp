#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analyze/trajectory_summary.hpp"
#include "deck/sampled_steps.hpp"

namespace ljmd {

/// The frames of a trajectory that are measured, and their spacing in time.
struct FrameSelection {
    /// The part that each frame belongs to: a stage of a run, or the frames between two places where files were joined.
    /// Nothing for excluded frames. Configurations at different times are compared only within a part.
    std::vector<std::optional<std::size_t>> parts;
    std::vector<Index> numbers;        ///< frame numbers, 1 apart; an analysis measures those that its `every` divides
    Index used;                        ///< number of measured frames
    Index longest_part;                ///< number of frames in the longest part
    std::optional<Index> steps_apart;  ///< between neighbouring frames, if it is the same for all
    std::optional<double> spacing;     ///< likewise, in time [tau]
    std::string uneven;                ///< why there is no common spacing
};

/// @param time_step  between steps, for files without times; between frames, for files without steps, too. If the times
/// of a file agree with it within rounding, it determines the spacing
/// @param stages     of the run; frames of stages that are not sampled are excluded
/// @param from       frames before this time [tau] are excluded
/// @throws InputError  `from` is given, but the frames have no times
/// @throws DataError   no frame is left
[[nodiscard]] FrameSelection select_frames(const TrajectorySummary& trajectory, std::optional<double> time_step,
                                           const std::vector<Stage>* stages, std::optional<double> from);

}  // namespace ljmd
