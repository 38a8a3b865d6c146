#pragma once

#include <string>

#include "ljmd/core/diagnostics.hpp"
#include "ljmd/core/section.hpp"

namespace ljmd {

/// Whether the deck or a --set contains this key, so that its value is not the default.
[[nodiscard]] bool is_written(const Section& section, const std::string& key);

/// Warn of settings in a fluid's deck that have no effect: unused keys, stages and analyses that measure nothing,
/// thermostats that never act. Effects that depend on the start are left to check_start_effects().
/// @pre  the deck has no errors
void check_effects(const Section& root, Diagnostics& diagnostics);

/// The same for a few-body deck. @pre  the deck has no errors
void check_few_body_effects(const Section& root, Diagnostics& diagnostics);

}  // namespace ljmd
