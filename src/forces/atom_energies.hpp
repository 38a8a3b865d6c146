#pragma once

#include <vector>

#include "ljmd/detail/model/state.hpp"
#include "ljmd/potentials/pair_potential.hpp"

namespace ljmd {

/// Energy of each atom, by id [epsilon]: half of the energies of its pairs,
///
///     u_i = 1/2 sum over j with r_ij < rc of u(r_ij),   sum over i of u_i = U.
///
/// The half is a convention, in which the pair energy belongs to both atoms alike. No tail correction is in it.
/// Scalar code in double precision, whatever the state's execution has: U of the kernels differs by rounding, in mixed
/// precision by its error. Each atom is summed by one thread in an order that the positions alone decide, so no bit
/// depends on the number of threads or on the order of the atoms in memory. The state is not changed.
///
/// Source: M. P. Allen and D. J. Tildesley, Computer Simulation of Liquids (2nd ed., 2017), section 2.4, which
/// builds the energy density from them
/// @pre the state has a box, and the cutoff is at most half its shortest edge (checked: ContractViolation)
[[nodiscard]] std::vector<double> atom_energies(const State& state, const PairPotential& potential);

}  // namespace ljmd
