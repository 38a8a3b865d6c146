#pragma once

#include <optional>

#include "ljmd/core/archive.hpp"

namespace ljmd {

/// The polar angle of a motion whose coordinate is the distance alone, and its rate.
struct PolarAngle {
    double value;  ///< [rad], unwrapped, 0 at the first sample
    double rate;   ///< [rad/time]

    void archive(Archive& a) { a(value, rate); }
};

/// Finds the angle by quadrature of its rate, theta' = h / rho^2 for a body of specific angular momentum h, with the
/// trapezoidal rule and its first correction over the steps:
///
///     theta(t + dt) = theta(t) + (dt/2) (theta'(t) + theta'(t + dt)) + (dt^2/12) (theta''(t) - theta''(t + dt))
///
/// Its error is of fourth order in the steps, below that of the integrators of the Verlet family; steps of an adaptive
/// method may be of any lengths. Source: Abramowitz and Stegun (1964), 25.4.4
class PolarAngleQuadrature {
  public:
    /// The next sample.
    /// @param slope  of the rate, theta''  @return the angle there
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

    /// The motion is turned round: the rate changes its sign, its slope does not. @return the angle, where it was
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
