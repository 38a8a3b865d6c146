#pragma once

#include "ljmd/deck/deck.hpp"
#include "ljmd/engine/time_loop.hpp"

namespace ljmd {

/// The stages of a deck whose run has an output directory, where a failure leaves failed.xyz. See run_stages().
/// @throws PhysicsError naming the step, the stage and that file
LoopSeconds run_stages(const Deck& deck, State& state, ForceField& force_field, StepObserver& observer,
                       const std::optional<LoopPosition>& from = std::nullopt);

}  // namespace ljmd
