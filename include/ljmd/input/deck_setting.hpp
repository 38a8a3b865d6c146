#pragma once

#include <string>
#include <vector>

#include "ljmd/core/diagnostics.hpp"
#include "ljmd/core/value.hpp"

namespace ljmd {

/// Apply one `--set`: "system.density=0.8" gives `density` in the table `system` the value 0.8, whether the key was
/// there or not.
///
/// Tables on the way are made when they are missing. An element of an array of tables is reached by its `name`,
/// "stage.production.steps=1000", or, where no element has one, by its number counted from 1: "body.2.mass=0.5". A part
/// of a key that holds a dot stands in quotes. The value is read as TOML, "body.2.position=[1.0, 0.0]"; what is no TOML
/// is taken as a string, so that "potential.truncation=cut" and "system.temperature=86 K" need no quotes.
///
/// What was set is located in a source named "--set system.density=0.8", in line 0 and the column of the value. Where
/// an earlier setting has given the same key, a warning tells that it has no effect. A setting that cannot be applied
/// gives one error and leaves the table as it was.
void apply_setting(Table& table, const std::string& assignment, Diagnostics& diagnostics);

/// The parts of the key of a setting, "stage", "production" and "steps"; quotes and blanks around them are left out.
/// Empty when a part is empty or a quote is left open.
[[nodiscard]] std::vector<std::string> setting_key(const std::string& text);

}  // namespace ljmd
