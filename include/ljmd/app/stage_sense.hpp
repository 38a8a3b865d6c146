#pragma once

#include <vector>

#include "ljmd/core/diagnostics.hpp"
#include "ljmd/core/section.hpp"

namespace ljmd {

/// The name of every stage stands in messages and in --set: it must be one, and the only one. The steps of all stages
/// must add up to a number that can be counted.
void check_stage_names(const std::vector<Section>& stages, Diagnostics& diagnostics);

}  // namespace ljmd
