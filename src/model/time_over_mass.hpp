#pragma once

namespace ljmd {

/// dt/m for one atom after the other. Divides only where the mass changes: nearly all atoms have the same mass, and
/// divisions took a fifth of the time of kicks and drifts.
class TimeOverMass {
  public:
    explicit TimeOverMass(double dt) : dt_(dt), quotient_(dt) {}
    double operator()(double mass) {
        if (mass != mass_) {
            mass_ = mass;
            quotient_ = dt_ / mass;
        }
        return quotient_;
    }

  private:
    double dt_;
    double mass_ = 1.0;
    double quotient_;
};

}  // namespace ljmd
