#pragma once

#include <optional>

#include "ljmd/core/units.hpp"

namespace ljmd {

/// One reduced unit of each kind in the units of a file.
struct UnitScale {
    double length = 1.0;    ///< of sigma
    double time = 1.0;      ///< of tau
    double velocity = 1.0;  ///< of sigma/tau
};

/// The scale of a file with times in picoseconds; ones for a reduced file.
/// @param per_nanometre  how many units of length the file counts in a nanometre
[[nodiscard]] inline UnitScale unit_scale(const std::optional<SubstanceUnits>& si, double per_nanometre) {
    if (!si) {
        return {};
    }
    const double length = per_nanometre * si->nanometre();
    return {length, si->picosecond(), length / si->picosecond()};
}

}  // namespace ljmd
