#pragma once

#include <filesystem>
#include <string>

namespace ljmd {

/// Contents of a run's directory and progress of the run: `ljmd info RUNDIR`.
/// @throws DataError  it is not the directory of a run
[[nodiscard]] std::string directory_report(const std::filesystem::path& directory);

/// The same as JSON: deck, title, kind, finished, running, began, resumed_at_steps, total_steps; checkpoint: step,
/// stage and atoms of the newest intact one, or null; damaged, a list of faults of others; files, name and bytes.
[[nodiscard]] std::string directory_json(const std::filesystem::path& directory);

}  // namespace ljmd
