#pragma once

#include "ljmd/detail/model/state.hpp"
#include "ljmd/potentials/pair_potential.hpp"

namespace ljmd {

/// Density and pressure in layers of equal thickness across a periodic box, of one configuration.
///
/// In a layer of volume A h,
///
///     rho   = n/(A h)
///     p_N   = (1/(A h)) (N/(N - 1) sum_i m v_z^2             + sum_pairs w dz^2            fraction)
///     p_T   = (1/(A h)) (N/(N - 1) sum_i m (v_x^2 + v_y^2)/2 + sum_pairs w (dx^2 + dy^2)/2 fraction)
///
/// with w = -u'(r)/r, sums over the atoms of the layer and over all pairs, and velocities about the centre of mass.
/// `fraction` is the part of the straight line between the two atoms that lies in the layer (Irving and Kirkwood's
/// contour). At equilibrium p_N is the same in all layers. The means over the layers are N/V and the components of the
/// pressure tensor without tail, see Thermodynamics.
/// Source: Irving and Kirkwood (1950), doi:10.1063/1.1747782; Walton et al. (1983), doi:10.1080/00268978300100971
struct PressureProfile {
    Eigen::VectorXd density;     ///< rho [sigma^-3]
    Eigen::VectorXd normal;      ///< p_N [epsilon/sigma^3]
    Eigen::VectorXd tangential;  ///< p_T [epsilon/sigma^3]
};

/// @param state   at least two atoms in a box; is not changed
/// @param axis    normal to the layers: 0, 1 or 2 for x, y or z
/// @param centre  coordinate in the middle of the layers [sigma]: the first one begins half an edge below it
/// @param layers  at least 1
/// @pre the cutoff is at most half the shortest edge (checked: ContractViolation)
[[nodiscard]] PressureProfile pressure_profile(const State& state, const PairPotential& potential, Index axis,
                                               double centre, Index layers);

/// The middle of a film [sigma]: the phase of sum_i exp(2 pi i z/L), which does not depend on where the box begins.
[[nodiscard]] double film_centre(const State& state, Index axis);

}  // namespace ljmd
