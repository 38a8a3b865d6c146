#pragma once

#include "deck/tables/few_body_tables.hpp"
#include "ljmd/detail/options/diagnostics.hpp"

namespace ljmd {

/// Check a few-body deck for sense: all vectors have as many components as the force and the other bodies need, no two
/// bodies are in one place, and analyses refer to existing bodies.
/// @param tables  single values may have been found wrong
void check_few_body_sense(const Placed<FewBodyTables>& tables, Diagnostics& diagnostics);

}  // namespace ljmd
