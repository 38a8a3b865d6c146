#pragma once

#include <filesystem>

#include "core/document.hpp"

namespace ljmd {

/// Contents of a run's directory and progress of the run: `ljmd info RUNDIR`.
/// Data: deck, title, kind, finished, running, began, resumed_at_steps, total_steps; checkpoint: step,
/// stage and atoms of the newest intact one, or null; damaged, a list of faults of others; files, name and bytes.
/// @throws DataError  it is not the directory of a run
[[nodiscard]] Document directory_report(const std::filesystem::path& directory);

}  // namespace ljmd
