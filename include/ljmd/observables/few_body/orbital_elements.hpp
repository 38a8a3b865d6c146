#pragma once

#include "ljmd/core/archive.hpp"
#include "ljmd/core/types.hpp"

namespace ljmd {

/// Osculating elements of a two-body orbit: those of the Kepler orbit that has this relative position and velocity.
/// Units follow from those of r, v and mu; energy and angular momentum are per reduced mass.
struct OrbitalElements {
    double specific_energy;         ///< E = v^2/2 - mu/r; negative when bound
    Vec3 angular_momentum;          ///< h = r x v
    double semi_major_axis;         ///< a = -mu/(2 E): negative on a hyperbola, infinite on a parabola
    double eccentricity;            ///< |e|, e = (v x h)/mu - r/|r| (Laplace-Runge-Lenz vector / mu); 1 on a line
    double period;                  ///< 2 pi (a^3/mu)^(1/2); infinite when unbound
    double pericentre;              ///< h^2 / (mu (1 + |e|)): smallest distance
    double apocentre;               ///< a (1 + |e|): largest distance; infinite when unbound
    double argument_of_pericentre;  ///< atan2(e_y, e_x) in (-pi, pi], see below

    void archive(Archive& a) {
        a(specific_energy, angular_momentum, semi_major_axis, eccentricity, period, pericentre, apocentre,
          argument_of_pericentre);
    }
};

/// The argument of pericentre is the polar angle, from the x axis towards the y axis, of the projection of e on the x-y
/// plane. For an orbit in that plane it is the direction of the pericentre, whichever the sense of the motion; for
/// another plane it is not the angle from the ascending node of astronomy. A circle has no pericentre: there it is
/// rounding.
///
/// Source: Murray and Dermott, Solar System Dynamics (1999), sections 2.3 and 2.8; Goldstein, Poole and Safko,
/// Classical Mechanics (2002), section 3.9.
/// @param r   position of one body relative to the other
/// @param v   its velocity relative to the other
/// @param mu  strength of the attraction mu/r^2 of the relative motion: G (m1 + m2)
/// @throws ContractViolation unless mu > 0 and |r| > 0
[[nodiscard]] OrbitalElements orbital_elements(const Vec3& r, const Vec3& v, double mu);

}  // namespace ljmd
