#pragma once

#include <string>

#include "ljmd/cli/commands.hpp"

namespace ljmd {

/// ljmd run DECK --replicas N: independent runs of one deck, each with a seed and a directory of its own, and their
/// merged results. Finished replicas are kept, interrupted ones are resumed.
/// @param out   replaces the deck's output directory unless empty
/// @param jobs  replicas at a time; 0: the number of processors
void replicas_command(const DeckOptions& options, const std::string& out, Index replicas, int jobs);

/// Whether a directory holds replicas. @throws DataError  its sweep.json is damaged
[[nodiscard]] bool holds_replicas(const std::string& directory);

/// ljmd resume DIR: resume all replicas in a directory, add steps to all of them, and merge their results anew.
/// @pre holds_replicas(options.directory)
void resume_replicas(const ResumeOptions& options, int jobs);

}  // namespace ljmd
