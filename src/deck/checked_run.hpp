#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/document.hpp"
#include "deck/deck.hpp"
#include "deck/fluid.hpp"
#include "ljmd/execution/execution.hpp"

namespace ljmd {

/// A run before its system is made, and what will compute it.
struct CheckedRun {
    std::optional<Start> start;  ///< of a fluid; few bodies stand in the deck
    Execution execution;

    [[nodiscard]] std::optional<Index> atoms() const { return start ? std::optional(start->atoms) : std::nullopt; }
};

/// Do the checks that need more than the text of a deck: the checks of its start file, and whether the system grants
/// the threads.
/// @param threads, simd  of a fluid, see execution_options()
/// @param ranks          that share the fluid; null: this process alone
/// @param diagnostics    receives the warnings; those about few bodies are all known when the deck has been read
/// @throws InputError with all mistakes; DataError as find_start(), ThreadsError
[[nodiscard]] CheckedRun checked_run(const Deck& deck, int threads, const std::string& simd, Diagnostics& diagnostics,
                                     const std::shared_ptr<Ranks>& ranks = nullptr);

/// The report of `ljmd check`: what is run, and what it costs. A fluid runs for less than a second for it, see
/// forecast().
[[nodiscard]] Document check_report(const Deck& deck, const CheckedRun& run);

}  // namespace ljmd
