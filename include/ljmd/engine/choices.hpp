#pragma once

#include <string>

#include "ljmd/options/choice.hpp"

namespace ljmd {

/// Plug-ins by name, with some of their options by the keys of a deck: checked at once, and with all other options at
/// their defaults. A Choice that is written as a value is checked by mistakes(). `ljmd info --keys` and
/// docs/deck-reference.md list all.
/// @throws InputError for an unknown name or key, and for a value of another type or outside its range
[[nodiscard]] Choice integrator(const std::string& name, const Settings& settings = {});
[[nodiscard]] Choice thermostat(const std::string& name, const Settings& settings = {});
[[nodiscard]] Choice barostat(const std::string& name, const Settings& settings = {});
[[nodiscard]] Choice analysis(const std::string& name, const Settings& settings = {});
[[nodiscard]] Choice few_body_force(const std::string& name, const Settings& settings = {});
[[nodiscard]] Choice few_body_analysis(const std::string& name, const Settings& settings = {});

}  // namespace ljmd
