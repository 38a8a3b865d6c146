#pragma once

#include <optional>
#include <vector>

#include "ljmd/core/section.hpp"
#include "ljmd/engine/stage.hpp"

namespace ljmd {

/// The stages of a deck, which may still have mistakes: a value that validation has found wrong is a stand-in, and a
/// thermostat or barostat whose type is wrong is left out.
/// @param root  the deck, of either kind
[[nodiscard]] std::vector<Stage> stages_of(const Section& root);

/// Target temperature of a stage's thermostat [epsilon/k_B]: `temperature` of the stage, else of the system; nothing if
/// neither has a valid one.
[[nodiscard]] std::optional<double> stage_temperature(const Section& stage, const Section& root);

}  // namespace ljmd
