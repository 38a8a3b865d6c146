#pragma once

#include <vector>

#include "compare/agreement.hpp"
#include "compare/peer.hpp"
#include "ljmd/detail/forces/force_field.hpp"

namespace ljmd {

/// Evaluate a configuration with ljmd. @param execution  for its state
[[nodiscard]] PeerPoint point_of(const Fluid& fluid, ForceField& force_field, const Execution& execution = {});

/// Pressure without tail correction, by the convention for both programs: (2 K + W)/3V, as LAMMPS prints it, instead of
/// rho T + W/3V [epsilon/sigma^3].
[[nodiscard]] double pressure(const Totals& totals, const Fluid& fluid);

/// Compare energy, forces, pressure, and the tail corrections that both programs have.
///
/// Differences of forces are divided by the root mean square force of the other program, or by 1 if that vanishes, as
/// on a lattice.
[[nodiscard]] std::vector<Check> compare_points(const PeerPoint& ours, const PeerPoint& theirs, const Fluid& fluid,
                                                const Agreement& agreement);

}  // namespace ljmd
