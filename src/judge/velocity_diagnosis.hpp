#pragma once

#include <optional>
#include <string>

#include "judge/frame_judgement.hpp"

namespace ljmd {

/// By which known mistake the velocities of a frame differ from ours: of those that explain 99 % of the difference the
/// one that leaves least; of equal ones the first.
///
///     half-step velocities    v' = v -+ a dt/2
///     one step late, early    v'(t) = v(t -+ dt)
///     velocities              v' = -v; v' = c v; v' = 0; v' = v + const; two axes are exchanged, or one has the wrong
///                             sign; they stand in the rows of other atoms; one atom alone is wrong, with its id
///
/// Frames are looked at as long as the two trajectories are together, and their positions are right.
/// @param agreement  below it nothing is a difference
/// @return a sentence about the first frame whose mistake is known; nothing if there is none
[[nodiscard]] std::optional<std::string> diagnose_velocities(const JudgedTrajectory& trajectory,
                                                             const Agreement& agreement);

}  // namespace ljmd
