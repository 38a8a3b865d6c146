#pragma once

#include "ljmd/core/types.hpp"
#include "ljmd/detail/reference/equation_of_state.hpp"

namespace ljmd {

/// What N atoms in a periodic box at a given temperature have more than infinitely many, to first order in 1/N. In
/// reduced units, energies per atom.
struct SizeShift {
    double potential_energy;           ///< u
    double pressure;                   ///< p
    double excess_chemical_potential;  ///< mu_x, by insertion of an atom between the N
    double heat_capacity_cv;           ///< c_v
    double thermal_pressure;           ///< (dp/dT)_V
    double bulk_modulus;               ///< K_T = 1/kappa_T
};

/// The shift in the canonical ensemble. The number of atoms of a part of an infinite fluid fluctuates, by <dN^2> =
/// N S_0, S_0 = T/(dp/drho)_T, the number in a box of N atoms does not. By the method of the steepest descent their
/// excess Helmholtz energy is larger by (T/2) ln S_0, and with s = ln S_0
///
///     du     = -(T^2/2N) s_T                             dp      = (rho^2 T/2N) s_rho
///     dc_v   = -(1/2N) (2 T s_T + T^2 s_TT)              d(dp/dT) = (rho^2/2N) (s_rho + T s_Trho)
///     dmu_x  = (1/2N) (dp/drho - T + rho T s_rho)        dK_T    = (T/2N) (2 rho^2 s_rho + rho^3 s_rhorho)
///
/// the last for a change of the volume of N atoms. What depends on the shape of the box is left out: it decays
/// exponentially with its edge over the correlation length, and is large near the critical point alone.
///
/// A pair potential with a cutoff acts on density fluctuations of its range only: what is far beyond it, in the tail
/// correction, does not depend on N. So dp/drho is the equation's less the tail's, with p_tail = c rho^2.
///
/// Derivatives of dp/drho are central differences, to 1e-6 of themselves.
/// @param tail  c [epsilon sigma^3], of the tail correction; 0 for the full potential
/// @pre temperature > 0, density > 0, atoms >= 2
/// @throws PhysicsError  dp/drho is not positive there: no phase is stable
/// Sources: Lebowitz and Percus (1961), doi:10.1103/PhysRev.124.1673; for mu_x Smit and Frenkel (1989), J. Phys.:
/// Condens. Matter 1, 8659, and Siepmann, McDonald and Frenkel (1992), doi:10.1088/0953-8984/4/3/009
[[nodiscard]] SizeShift canonical_size_shift(const EquationOfState& equation, double temperature, double density,
                                             Index atoms, double tail);

/// S_0 = T/(dp/drho)_T = rho T kappa_T: the structure factor at k = 0; 1 in an ideal gas, large near the critical
/// point.
/// @param tail  as above  @throws PhysicsError  as above
[[nodiscard]] double structure_factor_at_zero(const EquationOfState& equation, double temperature, double density,
                                              double tail);

}  // namespace ljmd
