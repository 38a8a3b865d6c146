#pragma once

#include <string>

#include "ljmd/core/diagnostics.hpp"
#include "ljmd/core/section.hpp"

namespace ljmd {

/// Whether the deck or a --set gives this key, so that it is not left to its default.
[[nodiscard]] bool is_written(const Section& section, const std::string& key);

/// Warn of what a fluid's deck gives in vain: keys that change nothing of the run, stages and analyses that measure
/// nothing, thermostats that never act. What depends on the start is left to check_start_effects().
/// @pre  the deck has no errors
void check_effects(const Section& root, Diagnostics& diagnostics);

/// The same for a deck of a few bodies. @pre  it has no errors
void check_few_body_effects(const Section& root, Diagnostics& diagnostics);

}  // namespace ljmd
