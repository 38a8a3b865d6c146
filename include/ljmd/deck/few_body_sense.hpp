#pragma once

#include "ljmd/core/diagnostics.hpp"
#include "ljmd/core/section.hpp"

namespace ljmd {

/// Check a few-body deck for sense: all vectors have as many components as the force and the other bodies need, no two
/// bodies are in one place, and analyses refer to existing bodies.
/// @param root  validated with few_body_schema(); single values may have been found wrong
void check_few_body_sense(const Section& root, Diagnostics& diagnostics);

}  // namespace ljmd
