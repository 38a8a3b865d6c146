#pragma once

#include <filesystem>

#include "core/document.hpp"
#include "deck/deck.hpp"
#include "study/sweep_record.hpp"

namespace ljmd {

/// Whether a directory holds replicas. @throws DataError  its sweep.json is damaged
[[nodiscard]] bool holds_replicas(const std::filesystem::path& directory);

/// The deck of replicas with the settings of the command line. @throws InputError  it has mistakes
[[nodiscard]] Deck deck_of_replicas(const SweepPlan& plan);

/// Run all replicas to their ends, and merge their results: results.json, results.txt and merged tables in their
/// directory. Finished replicas are kept, interrupted ones are resumed.
/// @param directory  locked, and prepared by prepare_sweep()
/// @param jobs       replicas at a time; 0: the number of processors
/// @param quiet      say nothing when one ends
/// @return the report that was written
/// @throws PhysicsError  if any have failed  @throws Interrupted by a signal
Document complete_replicas(const SweepPlan& plan, const OpenDirectory& directory, const Deck& deck, int jobs,
                           bool quiet);

}  // namespace ljmd
