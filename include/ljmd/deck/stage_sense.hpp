#pragma once

#include <optional>
#include <vector>

#include "ljmd/core/diagnostics.hpp"
#include "ljmd/core/section.hpp"
#include "ljmd/integrators/thermostat.hpp"

namespace ljmd {

/// The name of every stage stands in messages and in --set: it must be one, and the only one. The steps of all stages
/// must add up to a number that can be counted.
void check_stage_names(const std::vector<Section>& stages, Diagnostics& diagnostics);

/// The kind of thermostat that a stage of a fluid has; nothing when it has none, or a wrong one.
[[nodiscard]] std::optional<ThermostatMethod> thermostat_method(const Section& stage);

/// What the thermostat of a stage is to hold [epsilon/k_B]: `temperature` of the stage, or else of the system; nothing
/// when neither has one.
/// @param root  a deck's
[[nodiscard]] std::optional<double> stage_temperature(const Section& stage, const Section& root);

/// Whether thermostat and barostat of a stage of a fluid go with its integrator, with each other and with what is
/// sampled.
void check_baths(const Section& stage, const Section& root, Diagnostics& diagnostics);

}  // namespace ljmd
