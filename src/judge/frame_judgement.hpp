#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/agreement.hpp"
#include "compare/fluid.hpp"
#include "ljmd/core/types.hpp"
#include "ljmd/detail/forces/force_field.hpp"
#include "ljmd/execution/execution.hpp"

namespace ljmd {

/// Where atoms are, and how fast; empty vectors are missing.
struct Motion {
    std::vector<Vec3> positions{};   ///< unwrapped [sigma]
    std::vector<Vec3> velocities{};  ///< [sigma/tau]
};

/// A frame of an engine's trajectory beside what ljmd says about that step. Empty vectors are missing.
struct JudgedFrame {
    Index step = 0;
    std::vector<Vec3> positions{};   ///< the engine's, wrapped or not [sigma]
    std::vector<Vec3> velocities{};  ///< the engine's [sigma/tau]
    std::vector<Vec3> forces{};      ///< the engine's [epsilon/sigma]

    std::vector<Vec3> forces_there{};    ///< ljmd's at the engine's positions
    std::vector<Vec3> our_positions{};   ///< at this step of ljmd's trajectory, unwrapped
    std::vector<Vec3> our_velocities{};  ///< at the same step
    std::vector<Vec3> our_forces{};      ///< at the same step
    Motion before{};                     ///< ours one step earlier; empty at step 0
    Motion after{};                      ///< ours one step later
};

/// The trajectory of an engine at constant energy; atoms have the mass 1.
struct JudgedTrajectory {
    Vec3 edges;
    double time_step;
    std::vector<JudgedFrame> frames;  ///< ascending steps
};

/// The largest distance between an engine's position of an atom and ours, by nearest images; NaN if a position is not a
/// number.
[[nodiscard]] double largest_distance(const JudgedFrame& frame, const Vec3& edges);

/// The largest difference of an atom's two velocities that goes with the limit of distances [sigma/tau]: a distance d
/// that two trajectories are apart comes with velocities that differ by up to 40 d/tau, the fastest that neighbours
/// swing in a dense fluid; and velocities that are made of positions, as (r' - r)/dt, have the rounding of two of them.
///
///     max(40/tau d(step), 2 d(1)/dt)
///
/// Nothing beyond the last limit of distances.
[[nodiscard]] std::optional<double> velocity_limit(const Agreement& agreement, Index step, double time_step);

/// The largest difference between an engine's velocity of an atom and ours [sigma/tau]; NaN if one is not a number.
/// @pre the frame has velocities of both
[[nodiscard]] double largest_velocity_difference(const JudgedFrame& frame);

/// The largest difference between an engine's forces and those at its positions, over the root mean square of the
/// latter.
/// @pre the frame has forces
[[nodiscard]] double largest_force_difference(const JudgedFrame& frame);

/// Checks of the frames at the judged steps: distances of positions, and velocities over their root mean square, up to
/// the step where the limits end; kinetic energies up to step 100; forces at the engine's own positions, which tell a
/// wrong formula or list from another trajectory.
/// @param judged  steps to check; frames at other steps are not
[[nodiscard]] std::vector<Check> check_trajectory(const JudgedTrajectory& trajectory, const std::vector<Index>& judged,
                                                  const Agreement& agreement);

/// By which known mistakes the trajectory differs from ours, a sentence each:
///
///     velocities             see diagnose_velocities()
///     a wrong method         explicit Euler, a kick that is missing or too long, a start half a step off, other
///                            velocities at the start: followed over the next frames, see wrong_method()
///     another time step      r'(1) = r(0) + v(0) dt' + a(0) dt'^2/2
///     a stale list           forces of the first frame are right, and in a later one some pairs' within the cutoff are
///                            missing
///     the integration        forces are right at the engine's positions, but the atoms are elsewhere
///
/// @param force_field  ljmd's, to follow wrong methods with  @param execution  for the states
/// @param agreement  below it nothing is a difference
[[nodiscard]] std::vector<std::string> diagnose_trajectory(const JudgedTrajectory& trajectory, const Fluid& fluid,
                                                           ForceField& force_field, const Execution& execution,
                                                           const Agreement& agreement);

}  // namespace ljmd
