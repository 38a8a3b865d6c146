#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ljmd/deck/deck.hpp"
#include "ljmd/forces/few_body_force.hpp"
#include "ljmd/model/state.hpp"
#include "ljmd/observables/few_body/few_body_analysis.hpp"

namespace ljmd {

/// The bodies of a deck at their start, without a box; ids in the order of the deck. Masses are the inertia that the
/// force assigns.
/// @pre position and velocity of every [[body]] have one to three components
[[nodiscard]] State few_body_start(const std::vector<Section>& bodies, const FewBodyForceOptions& force);

/// The bodies, forces and analyses of a few-body run.
struct FewBodySystem {
    State state;
    int dimensions;
    ChosenFewBodyForce force;
    std::unique_ptr<ForceField> force_field;
    std::vector<std::pair<std::string, std::unique_ptr<FewBodyAnalysis>>> analyses;
};

/// @pre the deck is a valid few-body deck
[[nodiscard]] FewBodySystem make_few_body_system(const Deck& deck);

}  // namespace ljmd
