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
/// trapezoidal rule over the steps: theta(t + dt) = theta(t) + (dt/2) (theta'(t) + theta'(t + dt)). Second order, like
/// the integrators of the Verlet family.
class PolarAngleQuadrature {
  public:
    /// The next sample. @return the angle there
    PolarAngle add(double time, double rate) {
        if (last_time_) {
            angle_.value += 0.5 * (time - *last_time_) * (angle_.rate + rate);
        }
        last_time_ = time;
        angle_.rate = rate;
        return angle_;
    }

    void archive(Archive& a) { a(last_time_, angle_); }

  private:
    std::optional<double> last_time_;
    PolarAngle angle_{0.0, 0.0};
};

}  // namespace ljmd
