#pragma once

#include <string>

#include "ljmd/deck/deck.hpp"

namespace ljmd {

/// The report of `ljmd check` on a few-body deck: bodies, energy, stages, disk. Nothing is run.
/// @pre the deck is a valid few-body deck
[[nodiscard]] std::string few_body_check_report(const Deck& deck);
[[nodiscard]] std::string few_body_check_json(const Deck& deck);

}  // namespace ljmd
