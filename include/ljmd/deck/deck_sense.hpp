#pragma once

#include "ljmd/core/diagnostics.hpp"
#include "ljmd/core/section.hpp"
#include "ljmd/model/box.hpp"

namespace ljmd {

/// Check a deck for physical sense: values that are in range but do not fit together, or that are hardly meant. No file
/// is opened. Impossible values are errors. Unlikely values (a time step of 0.02 or more, a density above 1.5, a
/// temperature above 50) are errors, or warnings if `force` is set.
/// @pre root has [system], [potential] and [[stage]]
void check_sense(const Section& root, bool has_units, bool force, Diagnostics& diagnostics);

/// Check the cutoff (at most L/2) and the analyses against the box.
void check_box(const Section& root, Index atoms, const Box& box, Diagnostics& diagnostics);

}  // namespace ljmd
