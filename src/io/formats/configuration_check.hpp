#pragma once

#include <optional>
#include <string>
#include <utility>

#include "ljmd/model/configuration.hpp"

namespace ljmd {

/// Why a configuration cannot be used.
struct ConfigurationFault {
    std::optional<Index> atom;  ///< index from 0; none: the fault is in the box or the time
    std::string message;        ///< for an atom, the text after its name: "has the mass 0; ..."
    bool is_lost = false;       ///< the atom is nowhere, or moves with no velocity: see NotFinite
};

/// Check a configuration in reduced units, O(N): a usable box, finite numbers, positive masses, and no atom more than
/// 10^6 edges away, where rounding would lose its place in the box.
/// @return the first fault; nothing when there is none
[[nodiscard]] std::optional<ConfigurationFault> find_fault(const Configuration& configuration);

/// Two atoms (from 0) at the same place modulo the box, O(N log N); nothing when there are none. Places are compared on
/// the grid of the box, so that atoms which differ here also differ in a State.
/// @pre find_fault() finds nothing
[[nodiscard]] std::optional<std::pair<Index, Index>> find_coincident_atoms(const Configuration& configuration);

/// Whether three box vectors, given as rows, are along the axes: no off-diagonal component exceeds 1e-12 of the
/// shortest edge. The tolerance admits boxes computed from angles, where the cosine of 90 degrees is 6e-17.
[[nodiscard]] bool is_orthogonal(const Mat3& vectors);

}  // namespace ljmd
