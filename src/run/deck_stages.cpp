#include "ljmd/run/deck_stages.hpp"

#include "ljmd/core/errors.hpp"
#include "ljmd/deck/simulation.hpp"
#include "ljmd/run/run_record.hpp"

namespace ljmd {

LoopSeconds run_stages(const Deck& deck, State& state, ForceField& force_field, StepObserver& observer,
                       const std::optional<LoopPosition>& from) {
    try {
        const auto interaction =
            deck.kind == DeckKind::fluid ? std::optional(interaction_of(deck)) : std::optional<Interaction>();
        return run_stages(deck.stages, state, force_field, observer, from, interaction);
    } catch (const PhysicsError& error) {
        throw PhysicsError(error.what() + save_failure(deck, state));
    }
}

}  // namespace ljmd
