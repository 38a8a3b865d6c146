#pragma once

#include <optional>
#include <string>

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

}  // namespace ljmd
