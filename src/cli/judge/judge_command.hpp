#pragma once

#include <string>

#include "cli/deck_options.hpp"
#include "compare/crosscheck.hpp"
#include "deck/checked_run.hpp"

namespace ljmd {

// ljmd compare DECK --with command:'./engine {input} {output}', and --with files:DIR.

/// Whether the program to compare with is an engine: "command:..." or "files:...".
[[nodiscard]] bool is_engine(const std::string& with);

/// Refuse options that have no meaning for an engine, and a command that is none. Changes nothing.
/// @throws InputError
void check_engine_options(const CrosscheckOptions& compared);

/// Judge the engine, and print the judgement. With files:DIR, a directory without a problem receives it, and nothing is
/// judged.
/// @param fluid  start of the deck
/// @param out    directory for judge.json, and for the files that were exchanged with a command; empty: none
/// @throws PhysicsError  a check failed  @throws DataError  there is no answer, or one that cannot be used
void judge_engine(const Deck& deck, CheckedRun fluid, const DeckOptions& options, const CrosscheckOptions& compared,
                  const std::string& out);

}  // namespace ljmd
