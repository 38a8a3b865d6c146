#pragma once

#include <string>

#include "judge/frame_judgement.hpp"

namespace ljmd {

/// Digits that frames lack, or that the start has lost when it was read, or one atom of it that stands elsewhere; empty
/// if positions are right, or are off in another way. What else is wrong follows from it.
[[nodiscard]] std::string other_digits(const JudgedTrajectory& trajectory, const Agreement& agreement);

/// What the first step tells of the motion; empty if it is right, or wrong in another way:
///
///     mass                 r'(1) = r(0) + v(0) dt + F(0) dt^2/(2 m)
///     another time step    r'(1) = r(0) + v(0) dt' + a(0) dt'^2/2
///     one atom             all others are where they are to be
[[nodiscard]] std::string first_step(const JudgedTrajectory& trajectory, const Agreement& agreement);

}  // namespace ljmd
