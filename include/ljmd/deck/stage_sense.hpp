#pragma once

#include <optional>
#include <vector>

#include "ljmd/core/diagnostics.hpp"
#include "ljmd/core/section.hpp"
#include "ljmd/integrators/thermostat.hpp"

namespace ljmd {

/// Check the names of stages, which messages and --set refer to: printable and unique. Check that the total number of
/// steps can be counted.
void check_stage_names(const std::vector<Section>& stages, Diagnostics& diagnostics);

/// The thermostat of a fluid's stage; nothing if there is none, or a wrong one.
[[nodiscard]] std::optional<ThermostatMethod> thermostat_method(const Section& stage);

/// Target temperature of a stage's thermostat [epsilon/k_B]: `temperature` of the stage, else of the system; nothing if
/// neither has one.
/// @param root  the deck
[[nodiscard]] std::optional<double> stage_temperature(const Section& stage, const Section& root);

/// Check that thermostat and barostat of a fluid's stage fit its integrator, each other and sampling.
void check_baths(const Section& stage, const Section& root, Diagnostics& diagnostics);

}  // namespace ljmd
