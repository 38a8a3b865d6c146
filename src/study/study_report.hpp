#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>

#include "core/document.hpp"

namespace ljmd {

/// The file of `ljmd reference` with its request, and the folders with its replicas.
inline constexpr const char* reference_file = "reference.json";
inline constexpr std::array<const char*, 3> reference_phases{"pilot", "canonical", "transport"};

/// Whether a directory holds a study, which consists of many runs: a sweep (sweep.json), a reference (reference.json)
/// or a reproduced table (rows/).
[[nodiscard]] bool holds_study(const std::filesystem::path& directory);

/// Progress of the runs of a study: `ljmd info DIR`. A run is finished, running, stopped after a step, failed, or not
/// begun; for a failed one, the last error in its log is shown.
/// Data: kind ("sweep", "replicas", "reference" or "reproduction"), deck (of a sweep and of replicas), running, states
/// with the number of runs in each, and runs, a list of name, directory, state, step (null before the first
/// checkpoint), total_steps and words.
/// @param screen  columns of the terminal that the text has to fit; none: one line a run
/// @pre holds_study(directory)  @throws DataError  its sweep.json, or the run.json of one of its runs, is damaged
[[nodiscard]] Document study_report(const std::filesystem::path& directory,
                                    std::optional<std::size_t> screen = std::nullopt);

}  // namespace ljmd
