#pragma once

#include <string>

#include "ljmd/deck/deck.hpp"

namespace ljmd {

/// What `ljmd check` says of a few-body deck that is good: bodies, energy, stages, disk. Runs nothing.
/// @pre the deck is a few-body deck and has been checked
[[nodiscard]] std::string few_body_check_report(const Deck& deck);
[[nodiscard]] std::string few_body_check_json(const Deck& deck);

}  // namespace ljmd
