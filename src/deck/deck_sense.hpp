#pragma once

#include <optional>
#include <string>

#include "deck/tables/fluid_tables.hpp"
#include "ljmd/detail/options/diagnostics.hpp"
#include "ljmd/model/box.hpp"

namespace ljmd {

/// Check a deck for physical sense: values that are in range but do not fit together, or that are unlikely. No file
/// is opened. Impossible values are errors. Unlikely values (a time step of 0.02 or more, a density above 1.5, a
/// temperature above 50) are errors, or warnings if `force` is set.
/// @param tables  single values may have been found wrong
void check_sense(const Placed<FluidTables>& tables, bool has_units, bool force, Diagnostics& diagnostics);

/// Check `directory` in [output] of a deck of either kind. @param where  the place of the key
void check_directory(const std::optional<std::string>& directory, const Location& where, Diagnostics& diagnostics);

/// Check the cutoff (at most L/2) and the analyses against the box.
void check_box(const Placed<FluidTables>& tables, Index atoms, const Box& box, Diagnostics& diagnostics);

}  // namespace ljmd
