#pragma once

#include <optional>

#include "deck/deck.hpp"
#include "fuzz_target.hpp"

namespace ljmd::fuzz {

/// There is a deck or there are errors, and each is told.
inline void check_promises(const std::optional<Deck>& deck, const Diagnostics& diagnostics) {
    require(deck.has_value() == !diagnostics.has_errors(), "a deck is there in spite of errors, or not without");
    for (const Diagnostic& entry : diagnostics.entries()) {
        require(!format(entry).empty(), "a mistake without a word");
    }
    inputs_accepted += deck ? 1 : 0;
}

}  // namespace ljmd::fuzz
