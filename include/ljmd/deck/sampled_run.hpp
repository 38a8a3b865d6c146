#pragma once

#include "ljmd/core/diagnostics.hpp"
#include "ljmd/core/section.hpp"
#include "ljmd/engine/fluid_spec.hpp"

namespace ljmd {

/// sampled_run() of a deck, which may still have mistakes.
/// @pre root has [system] and at least one [[stage]]
[[nodiscard]] SampledRun sampled_run(const Section& root, Index atoms, const Box& box);

/// Check that the values in [analysis] fit the run, that the box stays constant, and that sampled stages have one time
/// step where analyses need that.
/// @pre as for sampled_run(), and root has [analysis]
void check_analysis(const Section& root, const SampledRun& run, Diagnostics& diagnostics);

}  // namespace ljmd
