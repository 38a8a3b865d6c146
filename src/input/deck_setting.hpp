#pragma once

#include <string>
#include <vector>

#include "ljmd/detail/options/diagnostics.hpp"
#include "ljmd/detail/options/value.hpp"

namespace ljmd {

/// The key by which a setting selects an element of an array of tables.
inline constexpr const char* element_name = "name";

/// Apply one `--set`: "system.density=0.8" sets `density` in the table `system` to 0.8, whether the key was present or
/// not.
///
/// Missing tables on the path are created. An element of an array of tables is selected by its `name`,
/// "stage.production.steps=1000", or, if no element has a name, by its number from 1: "body.2.mass=0.5". A part of a
/// key that contains a dot must be quoted. The value is parsed as TOML, "body.2.position=[1.0, 0.0]"; what is not TOML
/// becomes a string, so that "potential.truncation=cut" and "system.temperature=86 K" need no quotes.
///
/// The location of the value is in a source named "--set system.density=0.8", line 0, at the column of the value. If an
/// earlier setting has set the same key, a warning says that it has no effect. A setting that cannot be applied gives
/// one error and leaves the table unchanged.
void apply_setting(Table& table, const std::string& assignment, Diagnostics& diagnostics);

/// The parts of the key of a setting, "stage", "production" and "steps", without quotes and blanks. Empty when a part
/// is empty or a quote is not closed.
[[nodiscard]] std::vector<std::string> setting_key(const std::string& text);

}  // namespace ljmd
