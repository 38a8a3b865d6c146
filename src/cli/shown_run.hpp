#pragma once

#include <functional>

#include "cli/progress.hpp"
#include "core/document.hpp"
#include "deck/deck.hpp"

namespace ljmd {

/// Run, print the results, and write the page that the deck asks for.
/// @param run  tells `progress` how far it is
void show_run(const Deck& deck, Progress& progress, bool as_json, const std::function<Document()>& run);

}  // namespace ljmd
