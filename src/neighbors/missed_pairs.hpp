#pragma once

#include "ljmd/detail/model/state.hpp"
#include "neighbors/cluster_grid.hpp"

namespace ljmd {

/// Square of an atom's displacement [sigma^2].
/// @param now, before  the vectors of all atoms, vector_stride apart
[[nodiscard]] inline double squared_displacement(const double* now, const double* before, Index atom) {
    using Atom = Eigen::Map<const Eigen::Vector4d>;
    return (Atom(now + vector_stride * atom) - Atom(before + vector_stride * atom)).squaredNorm();
}

/// Whether two atoms that were at least cutoff + skin apart when the atoms were sorted, and so may be absent from the
/// neighbour list, may be within the cutoff now.
///
/// Together two such atoms have moved by at least the skin, so one of them by at least half of it. In a fluid the
/// fastest atom has moved that far long before any such pair is within the cutoff: that takes a neighbour that moves
/// towards it. So the surroundings of each atom that has moved by more than half the skin are searched for missing
/// pairs. Columns and clusters (see ClusterGrid) are skipped if none of their atoms has moved far enough to make up the
/// rest. Without a search the answer is true if too many atoms have moved by more than half the skin, if one has moved
/// by more than the whole skin, or if a position is not finite.
///
/// Exact but for rounding: pairs count as missed within a cutoff that is wider by a factor of 1 + 5e-7.
/// Collective where ranks share the atoms.
/// @param grid    columns and clusters of the atoms in their present order
/// @param before  positions when they were sorted, the ghosts' after them, laid out as for
/// squared_displacement() [sigma]
/// @param cutoff  > 0 [sigma]  @param skin  >= 0 [sigma]
/// @pre with other ranks, a halo of cutoff + 2 skin at least, wider by a factor of 1 + 5e-7
[[nodiscard]] bool any_pair_missed(const ClusterGrid& grid, const double* before, const State& state, double cutoff,
                                   double skin);

}  // namespace ljmd
