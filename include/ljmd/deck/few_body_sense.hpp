#pragma once

#include "ljmd/core/diagnostics.hpp"
#include "ljmd/core/section.hpp"

namespace ljmd {

/// Check a few-body deck for sense: as many components for every vector as the force and the other bodies have, no two
/// bodies in one place, analyses of bodies that are there.
/// @param root  validated with few_body_schema(); its single values may have been found wrong
void check_few_body_sense(const Section& root, Diagnostics& diagnostics);

}  // namespace ljmd
