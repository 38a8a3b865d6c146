#pragma once

#include <vector>

#include "ljmd/compare/agreement.hpp"
#include "ljmd/compare/peer.hpp"
#include "ljmd/forces/force_field.hpp"

namespace ljmd {

/// A configuration as ljmd evaluates it.
[[nodiscard]] PeerPoint point_of(const Fluid& fluid, ForceField& force_field);

/// Pressure without tail by the convention that both sides are held to: (2 K + W)/3V, as LAMMPS prints it, in place of
/// rho T + W/3V [epsilon/sigma^3].
[[nodiscard]] double pressure(const Totals& totals, const Fluid& fluid);

/// Energy, forces, pressure, and the tail corrections that both know.
///
/// Differences of forces are divided by the root mean square of the other program's, or by 1 where those vanish, as
/// they do on a lattice.
[[nodiscard]] std::vector<Check> compare_points(const PeerPoint& ours, const PeerPoint& theirs, const Fluid& fluid,
                                                const Agreement& agreement);

}  // namespace ljmd
