#pragma once

namespace ljmd {

/// dt/m of one atom after the other, divided only where the mass changes: with nearly all atoms of one mass, divisions
/// were a fifth of the time of kicks and drifts.
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
