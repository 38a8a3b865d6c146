#pragma once

#include <optional>

#include "ljmd/core/archive.hpp"
#include "ljmd/model/state.hpp"

namespace ljmd {

/// How far a time step h of a method of second order sets the temperatures of velocities and of configurations apart:
/// by how much the kinetic energy half a step later, with v + h f/(2 m) for v, exceeds the one at the step, on average.
///
///     (h^2/4) <sum f^2/m>/<sum m v^2>                     (w h/2)^2 for oscillators of angular frequency w
///
/// Where velocity Verlet is stable for oscillators (w h < 2), the ratio of their kinetic to their potential energy is
/// low by just this factor. It needs no long run, and does not see the jumps of the energy at a plain cut.
class TimeStepError {
  public:
    /// One configuration. @pre its forces are current
    void add(const State& state, double time_step);

    /// Empty without motion.
    [[nodiscard]] std::optional<double> value() const;

    void archive(Archive& a) { a(excess_, motion_); }

  private:
    double excess_ = 0.0;  ///< sum of h^2 f^2/(4 m)
    double motion_ = 0.0;  ///< sum of m v^2
};

}  // namespace ljmd
