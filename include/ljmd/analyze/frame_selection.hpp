#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ljmd/analyze/trajectory_summary.hpp"
#include "ljmd/deck/sampled_steps.hpp"

namespace ljmd {

/// Which frames of a trajectory are measured, and how far apart in time they are.
struct FrameSelection {
    /// For each frame the part that it belongs to: a stage of a run, what lies between two places where a file was
    /// joined; nothing for those that are left out. What compares configurations in time does so within a part.
    std::vector<std::optional<std::size_t>> parts;
    std::vector<Index> numbers;        ///< of the frames: those whose number `every` divides are measured; one apart
    Index used;                        ///< frames
    Index longest_part;                ///< frames in the longest part
    std::optional<Index> steps_apart;  ///< frames next to each other, where that is the same for all of them
    std::optional<double> spacing;     ///< likewise [tau]
    std::string uneven;                ///< why there is no spacing
};

/// @param time_step  between steps, for files without times; between frames, where they have no steps either. Where
///                   the times of a file agree with it but for rounding, it tells the spacing
/// @param stages     of the run that the trajectory is of: frames of stages that are not sampled are left out
/// @param from       frames before this time [tau] are left out
/// @throws InputError  `from` is given and the frames have no times
/// @throws DataError   no frame is left
[[nodiscard]] FrameSelection select_frames(const TrajectorySummary& trajectory, std::optional<double> time_step,
                                           const std::vector<Stage>* stages, std::optional<double> from);

}  // namespace ljmd
