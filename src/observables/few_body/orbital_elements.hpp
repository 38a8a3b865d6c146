#pragma once

#include "ljmd/core/types.hpp"
#include "ljmd/detail/core/archive.hpp"

namespace ljmd {

/// Osculating elements of a two-body orbit: the elements of the Kepler orbit with this relative position and velocity.
/// Units follow from the units of r, v and mu. Energy and angular momentum are per reduced mass.
struct OrbitalElements {
    double specific_energy;  ///< E = v^2/2 - mu/r; negative if bound
    Vec3 angular_momentum;   ///< h = r x v
    double semi_major_axis;  ///< a = -mu/(2 E): negative for a hyperbola, infinite for a parabola
    double eccentricity;     ///< |e|, e = (v x h)/mu - r/|r| (Laplace-Runge-Lenz vector / mu); 1 for motion on a line
    double period;           ///< 2 pi (a^3/mu)^(1/2); infinite if unbound
    double pericentre;       ///< smallest distance, h^2 / (mu (1 + |e|))
    double apocentre;        ///< largest distance, a (1 + |e|); infinite if unbound
    double argument_of_pericentre;  ///< atan2(e_y, e_x) in (-pi, pi], see below

    void archive(Archive& a) {
        a(specific_energy, angular_momentum, semi_major_axis, eccentricity, period, pericentre, apocentre,
          argument_of_pericentre);
    }
};

/// Compute the elements. The argument of pericentre is the polar angle, from the x axis towards the y axis, of the
/// projection of e on the x-y plane. For an orbit in that plane it is the direction of the pericentre, for either sense
/// of motion. For other planes it is not astronomy's angle from the ascending node. For a circle, which has no
/// pericentre, it is determined by rounding.
///
/// Source: Murray and Dermott, Solar System Dynamics (1999), sections 2.3 and 2.8; Goldstein, Poole and Safko,
/// Classical Mechanics (2002), section 3.9.
/// @param r   position of one body relative to the other
/// @param v   its velocity relative to the other
/// @param mu  strength of the attraction mu/r^2 of the relative motion: G (m1 + m2)
/// @throws ContractViolation unless mu > 0 and |r| > 0
[[nodiscard]] OrbitalElements orbital_elements(const Vec3& r, const Vec3& v, double mu);

}  // namespace ljmd
