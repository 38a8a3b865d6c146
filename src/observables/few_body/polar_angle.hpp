#pragma once

#include <optional>

#include "ljmd/detail/core/archive.hpp"

namespace ljmd {

/// Polar angle of a motion whose only coordinate is the distance, and its rate.
struct PolarAngle {
    double value;  ///< [rad], continuous, 0 at the first sample
    double rate;   ///< [rad/time]

    void archive(Archive& a) { a(value, rate); }
};

/// Integrates the rate of the polar angle, theta' = h / rho^2 for a body of specific angular momentum h, by the
/// trapezoidal rule with its first correction:
///
///     theta(t + dt) = theta(t) + (dt/2) (theta'(t) + theta'(t + dt)) + (dt^2/12) (theta''(t) - theta''(t + dt))
///
/// The error is of fourth order in the steps, below the error of integrators of the Verlet family. Steps may have any
/// lengths, as an adaptive method's do. Source: Abramowitz and Stegun (1964), 25.4.4
class PolarAngleQuadrature {
  public:
    /// Add the next sample.
    /// @param slope  derivative of the rate, theta''  @return the angle there
    PolarAngle add(double time, double rate, double slope) {
        if (last_time_) {
            const double dt = time - *last_time_;
            angle_.value += 0.5 * dt * (angle_.rate + rate) + dt * dt / 12.0 * (slope_ - slope);
        }
        last_time_ = time;
        angle_.rate = rate;
        slope_ = slope;
        return angle_;
    }

    /// The motion is reversed: the rate changes its sign, its derivative does not. @return the angle, which stays the
    /// same
    PolarAngle turn_round() {
        angle_.rate = -angle_.rate;
        return angle_;
    }

    void archive(Archive& a) { a(last_time_, angle_, slope_); }

  private:
    std::optional<double> last_time_;
    PolarAngle angle_{0.0, 0.0};
    double slope_ = 0.0;
};

}  // namespace ljmd
