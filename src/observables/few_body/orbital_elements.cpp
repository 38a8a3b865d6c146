#include "observables/few_body/orbital_elements.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>

#include "ljmd/core/errors.hpp"

namespace ljmd {

OrbitalElements orbital_elements(const Vec3& r, const Vec3& v, double mu) {
    const double distance = r.norm();
    if (!(mu > 0.0) || !(distance > 0.0)) {
        throw ContractViolation(
            fmt::format("orbital elements need mu > 0 and a distance > 0, not mu = {} and {}", mu, distance));
    }
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double energy = 0.5 * v.squaredNorm() - mu / distance;
    const bool bound = energy < 0.0;
    const Vec3 h = r.cross(v);
    const Vec3 e = v.cross(h) / mu - r / distance;
    const double a = energy == 0.0 ? infinity : -mu / (2.0 * energy);

    OrbitalElements elements;
    elements.specific_energy = energy;
    elements.angular_momentum = h;
    elements.semi_major_axis = a;
    elements.eccentricity = e.norm();
    elements.period = bound ? 2.0 * std::numbers::pi * a * std::sqrt(a / mu) : infinity;
    elements.pericentre = h.squaredNorm() / (mu * (1.0 + elements.eccentricity));
    elements.apocentre = bound ? a * (1.0 + elements.eccentricity) : infinity;
    elements.argument_of_pericentre = std::atan2(e.y(), e.x());
    return elements;
}

}  // namespace ljmd
