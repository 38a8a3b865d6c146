#pragma once

#include <string>

#include "compare/fluid.hpp"
#include "judge/frame_judgement.hpp"
#include "ljmd/detail/forces/force_field.hpp"
#include "ljmd/execution/execution.hpp"

namespace ljmd {

/// Whether the velocities of the first frame are not those of the start.
[[nodiscard]] bool starts_with_other_velocities(const JudgedTrajectory& trajectory, const Agreement& agreement);

/// By which wrong method the atoms move, if one takes them to where they are in the judged frames that follow the
/// start, with the velocities that are there:
///
///     r(t + dt) = r + v dt + c a dt^2        right: c = 1/2
///     v(t + dt) = v + b a dt + b' a(t + dt) dt      b = b' = 1/2
///
/// (explicit Euler, a kick that is missing or twice as long, a start half a step off), or velocity Verlet from other
/// velocities than those of the start. Empty if none does.
[[nodiscard]] std::string wrong_method(const JudgedTrajectory& trajectory, const Fluid& fluid, ForceField& force_field,
                                       const Execution& execution, const Agreement& agreement);

}  // namespace ljmd
