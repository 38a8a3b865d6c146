#pragma once

#include "ljmd/detail/model/state.hpp"
#include "ljmd/potentials/pair_potential.hpp"

namespace ljmd {

/// Sums over the pairs of a configuration that need the second derivative of the potential.
///
/// They belong to the potential in which the atoms move, u(r) - u(rc): energy is the integral of the force, whatever
/// the truncation. With y(r) = -r u'(r), the virial of a pair,
///
///     U   = sum over pairs of u(r) - u(rc)
///     X   = sum over pairs of r d(r u')/dr = -r y'                      hypervirial
///     L   = sum over atoms of lap_i U = sum over pairs of 2 (u'' + 2 u'/r) = -2 (r y' + y)/r^2
///
/// The force of `cut` and `shifted` jumps at the cutoff, so r y' has a term -rc y(rc) delta(r - rc) there, which no
/// configuration shows: pairs at exactly rc are counted by those just inside. With s = rc - r,
///
///     delta(r - rc) -> (rc/r)^2 (4 - 6 s/b)/b   for 0 < s < b = 0.1 sigma
///
/// which is exact for a g(r) that is linear in the shell; what is left, b^2 g''/12, is below 1 % of the term, which
/// itself is 3 % of 1/kappa_T at the triple point and rc = 2.5. For truncations whose force is continuous the term is
/// zero. y' is taken from y at r exp(+-1e-5), with a relative error of 1e-8, so that every potential has it, formulas
/// of a program and tables as well.
/// Source of X: Allen and Tildesley, Computer Simulation of Liquids, 2nd ed., equation 2.76 (there divided by 9).
struct PairCurvature {
    double energy = 0.0;       ///< U [epsilon]
    double hypervirial = 0.0;  ///< X [epsilon]
    double laplacian = 0.0;    ///< L [epsilon/sigma^2]

    PairCurvature& operator+=(const PairCurvature& other);
};

/// The state is not changed: the pairs are found in a copy. The bits do not depend on the number of threads.
/// @pre the cutoff is at most half the box
[[nodiscard]] PairCurvature pair_curvature(const State& state, const PairPotential& potential);

}  // namespace ljmd
