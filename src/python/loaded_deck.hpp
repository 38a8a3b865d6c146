#pragma once

#include <string>
#include <vector>

#include "deck/deck.hpp"
#include "ljmd/detail/options/diagnostics.hpp"
#include "python/values.hpp"

namespace ljmd::python {

/// A deck that was read without errors, with the warnings about it.
struct LoadedDeck {
    Deck deck;
    Diagnostics diagnostics;
};

/// The warnings, as they are printed.
[[nodiscard]] std::vector<std::string> warnings_of(const Diagnostics& diagnostics);

/// The tables of a deck that says what a FluidSpec says of itself, with one stage: the defaults of Deck.fluid and
/// Stage.
[[nodiscard]] py::dict default_tables();

/// Reading and checking decks.
void bind_decks(py::module_& module);

}  // namespace ljmd::python
