#pragma once

#include "ljmd/deck/deck.hpp"
#include "ljmd/engine/time_loop.hpp"

namespace ljmd {

/// Run the stages of a deck, see run_stages(). On a PhysicsError the configuration is saved as failed.xyz in the output
/// directory.
/// @throws PhysicsError with the step, the stage and that file
LoopSeconds run_stages(const Deck& deck, State& state, ForceField& force_field, StepObserver& observer,
                       const std::optional<LoopPosition>& from = std::nullopt);

}  // namespace ljmd
