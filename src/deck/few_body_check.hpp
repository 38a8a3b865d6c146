#pragma once

#include "core/document.hpp"
#include "deck/deck.hpp"

namespace ljmd {

/// The report of `ljmd check` on a few-body deck: bodies, energy, stages, disk. Nothing is run.
/// @pre the deck is a valid few-body deck
[[nodiscard]] Document few_body_check_report(const Deck& deck);

}  // namespace ljmd
