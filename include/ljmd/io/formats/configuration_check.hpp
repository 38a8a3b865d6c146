#pragma once

#include <optional>
#include <string>
#include <utility>

#include "ljmd/model/configuration.hpp"

namespace ljmd {

/// Why a configuration cannot be used.
struct ConfigurationFault {
    std::optional<Index> atom;  ///< from 0; none: the box or the time
    std::string message;        ///< of an atom, what follows its name: "has the mass 0; ..."
};

/// Checks on a configuration in reduced units, O(N): a box that can be computed with, all numbers finite, masses
/// positive, no atom more than 10^6 edges away (its place in the box would be lost to rounding).
/// @return the first fault; nothing when all is well
[[nodiscard]] std::optional<ConfigurationFault> find_fault(const Configuration& configuration);

/// Two atoms that are at the same place modulo the box, from 0, O(N log N); nothing when all are apart. Places are
/// compared on the grid of the box, so that what is told apart here stays apart in a State.
/// @pre find_fault() finds none
[[nodiscard]] std::optional<std::pair<Index, Index>> find_coincident_atoms(const Configuration& configuration);

/// Whether three box vectors, as rows, make a box along the axes: no component off the diagonal is above 1e-12 of the
/// shortest edge. Programs that compute a box from its angles write cosines of 90 degrees, of 6e-17, or tilt factors of
/// zero.
[[nodiscard]] bool is_orthogonal(const Mat3& vectors);

}  // namespace ljmd
