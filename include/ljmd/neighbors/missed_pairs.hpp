#pragma once

#include "ljmd/model/state.hpp"
#include "ljmd/neighbors/cluster_grid.hpp"

namespace ljmd {

/// Square of the way from where an atom was to where it is [sigma^2].
/// @param now, before  x y z of each atom, and behind them the zero of VectorView, so that whole vectors are computed
/// with
[[nodiscard]] inline double squared_displacement(const double* now, const double* before, Index atom) {
    using Atom = Eigen::Map<const Eigen::Vector4d>;
    return (Atom(now + 4 * atom) - Atom(before + 4 * atom)).squaredNorm();
}

/// Whether atoms that were at least cutoff + skin apart when they were sorted, and so need not stand on each other's
/// list, may be within the cutoff by now.
///
/// Together two such atoms have moved by at least the skin, so one of them by at least half of it. In a fluid the
/// fastest atom has gone that far long before any such pair meets: what matters is who is around it, and that both go
/// towards each other. So the atoms around those that have gone half the skin are looked at, but for columns of atoms
/// (see ClusterGrid) of which none has gone far enough to make up the rest. "May": when too many have gone half the
/// skin to look around all of them, when one has gone the whole skin, or when a position is not finite, nothing is
/// looked at.
///
/// Exact but for rounding, for which pairs within a cutoff 5e-7 of itself wider count.
/// @param grid    of the atoms as they are ordered now
/// @param before  of each atom when they were sorted, as squared_displacement() takes it [sigma]
/// @param cutoff  > 0 [sigma]  @param skin  >= 0 [sigma]
[[nodiscard]] bool any_pair_missed(const ClusterGrid& grid, const double* before, const State& state, double cutoff,
                                   double skin);

}  // namespace ljmd
