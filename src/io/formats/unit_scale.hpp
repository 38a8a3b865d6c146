#pragma once

#include <optional>

#include "ljmd/detail/options/units.hpp"

namespace ljmd {

/// One reduced unit of each kind, in the units of a file.
struct UnitScale {
    double length = 1.0;    ///< sigma
    double time = 1.0;      ///< tau
    double velocity = 1.0;  ///< sigma/tau
};

/// The scale of a file with times in picoseconds; all 1 for a file in reduced units.
/// @param per_nanometre  the file's units of length in a nanometre
[[nodiscard]] inline UnitScale unit_scale(const std::optional<SubstanceUnits>& si, double per_nanometre) {
    if (!si) {
        return {};
    }
    const double length = per_nanometre * si->nanometre();
    return {length, si->picosecond(), length / si->picosecond()};
}

}  // namespace ljmd
