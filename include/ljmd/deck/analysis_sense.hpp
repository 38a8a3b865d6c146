#pragma once

#include <vector>

#include "ljmd/core/diagnostics.hpp"
#include "ljmd/core/section.hpp"
#include "ljmd/engine/fluid_spec.hpp"

namespace ljmd {

/// What [analysis] of a fluid's deck asks for. @param analysis  may still have mistakes
[[nodiscard]] std::vector<ChosenAnalysis> chosen_analyses(const Section& analysis);

/// Check that the analyses fit the run, its box and its stages. Warn where a thermostat changes the motion that they
/// measure.
/// @param root  has [system], [analysis] and at least one [[stage]]; it may still have mistakes
/// @param box   at the start
void check_analyses(const Section& root, Index atoms, const Box& box, Diagnostics& diagnostics);

}  // namespace ljmd
