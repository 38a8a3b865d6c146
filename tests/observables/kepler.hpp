#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "ljmd/core/types.hpp"

/// Exact and numerical Kepler orbits that the tests of orbital observables sample.
namespace kepler {

using ljmd::Vec3;

struct Point {
    Vec3 r;
    Vec3 v;
};

/// An ellipse in the x-y plane with its pericentre on the positive x axis, run through anticlockwise.
struct Ellipse {
    double mu;
    double a;
    double e;

    [[nodiscard]] double motion() const { return std::sqrt(mu / (a * a * a)); }
    [[nodiscard]] double period() const { return 2.0 * std::numbers::pi / motion(); }

    /// Where the body is a time t after the pericentre: Kepler's equation E - e sin E = M by Newton's method.
    [[nodiscard]] Point at(double t) const {
        const double mean_anomaly = motion() * t;
        double anomaly = mean_anomaly + e * std::sin(mean_anomaly);
        for (int i = 0; i < 20; ++i) {
            anomaly -= (anomaly - e * std::sin(anomaly) - mean_anomaly) / (1.0 - e * std::cos(anomaly));
        }
        const double b = a * std::sqrt(1.0 - e * e);
        const double rate = motion() / (1.0 - e * std::cos(anomaly));
        return {Vec3(a * (std::cos(anomaly) - e), b * std::sin(anomaly), 0.0),
                Vec3(-a * std::sin(anomaly) * rate, b * std::cos(anomaly) * rate, 0.0)};
    }
};

/// The ellipse of mu = 1.001, r = (1, 0), v = (0, 1.2): a = mu/0.562 and e = 1.44/1.001 - 1.
inline Ellipse sample_ellipse() {
    return {1.001, 1.001 / 0.562, 1.44 / 1.001 - 1.0};
}

/// Kick-drift-kick leapfrog (velocity Verlet) in the field of mu.
class Leapfrog {
  public:
    Leapfrog(const Point& start, double mu, double dt) : now_(start), mu_(mu), dt_(dt) {}

    [[nodiscard]] const Point& now() const { return now_; }

    void step() {
        now_.v += 0.5 * dt_ * acceleration();
        now_.r += dt_ * now_.v;
        now_.v += 0.5 * dt_ * acceleration();
    }

  private:
    [[nodiscard]] Vec3 acceleration() const { return -mu_ / std::pow(now_.r.norm(), 3) * now_.r; }

    Point now_;
    double mu_;
    double dt_;
};

/// The point seen from a frame that is turned by `angle` and turns at `rate` about z.
inline Point turned(const Point& point, double angle, double rate) {
    const Eigen::AngleAxisd turn(angle, Vec3::UnitZ());
    return {turn * point.r, turn * Vec3(point.v + rate * Vec3::UnitZ().cross(point.r))};
}

}  // namespace kepler
