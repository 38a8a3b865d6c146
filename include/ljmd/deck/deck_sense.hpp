#pragma once

#include "ljmd/core/diagnostics.hpp"
#include "ljmd/core/section.hpp"
#include "ljmd/model/box.hpp"

namespace ljmd {

/// Check a deck for physical sense: values that are each in range but do not go together, or that no one means. Files
/// are not opened. What is impossible is an error; what is merely unlikely (a time step of 0.02 or more, a density
/// above 1.5, a temperature above 50) is an error too, unless forced, when it becomes a warning.
/// @pre root has [system], [potential] and [[stage]]
void check_sense(const Section& root, bool has_units, bool force, Diagnostics& diagnostics);

/// cutoff <= L/2, and what analyses ask of the run.
void check_box(const Section& root, Index atoms, const Box& box, Diagnostics& diagnostics);

}  // namespace ljmd
