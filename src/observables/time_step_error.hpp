#pragma once

#include <optional>

#include "ljmd/detail/core/archive.hpp"
#include "ljmd/detail/model/state.hpp"

namespace ljmd {

/// Difference between the temperatures of velocities and of configurations that a time step h of a second-order method
/// causes. It is the mean relative excess of the kinetic energy half a step later, with v + h f/(2 m) for v:
///
///     (h^2/4) <sum f^2/m - F^2/M>/<sum m v^2 - P^2/M>     (w h/2)^2 for oscillators of angular frequency w
///
/// It is for the motion about the centre of mass, which an external force may let fall; F is the force on it. In
/// fluids T_conf/T - 1 is 1.3 to 3 times as large, because stiff pairs count most in T_conf (docs/averages.md).
///
/// For oscillators within the stability limit of velocity Verlet (w h < 2), the ratio of kinetic to potential energy is
/// too low by exactly this fraction. The measurement needs no long run and does not see the energy jumps of a plain
/// cut.
class TimeStepError {
  public:
    /// Add a configuration. @pre its forces are current
    void add(const State& state, double time_step);

    /// Empty if nothing moves.
    [[nodiscard]] std::optional<double> value() const;

    void archive(Archive& a) { a(excess_, motion_); }

  private:
    double excess_ = 0.0;  ///< sum of h^2 f^2/(4 m)
    double motion_ = 0.0;  ///< sum of m v^2
};

}  // namespace ljmd
