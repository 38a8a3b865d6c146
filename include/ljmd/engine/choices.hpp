#pragma once

#include <string>

#include "ljmd/core/settings.hpp"
#include "ljmd/integrators/barostat.hpp"
#include "ljmd/integrators/integrator.hpp"
#include "ljmd/integrators/thermostat.hpp"
#include "ljmd/observables/analysis.hpp"

namespace ljmd {

/// Plug-ins by name, with some of their options by the keys of a deck; others keep their defaults. `ljmd info --keys`
/// and docs/deck-reference.md list all.
/// @throws InputError for an unknown name or key, and for a value of another type or outside its range
[[nodiscard]] ChosenIntegrator integrator(const std::string& name, const Settings& settings = {});
[[nodiscard]] ChosenThermostat thermostat(const std::string& name, const Settings& settings = {});
[[nodiscard]] ChosenBarostat barostat(const std::string& name, const Settings& settings = {});
[[nodiscard]] ChosenAnalysis analysis(const std::string& name, const Settings& settings = {});

}  // namespace ljmd
