#pragma once

#include <vector>

#include "ljmd/deck/deck.hpp"
#include "ljmd/engine/few_body_system.hpp"
#include "ljmd/forces/few_body_force.hpp"
#include "ljmd/model/state.hpp"

namespace ljmd {

/// The bodies of a deck at their start, without a box; ids in the order of the deck. Masses are the inertia that the
/// force assigns.
/// @pre position and velocity of every [[body]] have one to three components
[[nodiscard]] State few_body_start(const std::vector<Placed<BodyTable>>& bodies, const FewBodyForceOptions& force,
                                   const Execution& execution = {});

/// The system of a few-body deck at its start.
/// @pre the deck is a valid few-body deck
[[nodiscard]] FewBodySystem make_few_body_system(const Deck& deck, const Execution& execution = {});

}  // namespace ljmd
