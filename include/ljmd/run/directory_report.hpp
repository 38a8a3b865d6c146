#pragma once

#include <filesystem>
#include <string>

namespace ljmd {

/// What the directory of a run holds and how far the run got: `ljmd info RUNDIR`.
/// @throws DataError  it is not the directory of a run
[[nodiscard]] std::string directory_report(const std::filesystem::path& directory);

/// The same as JSON: deck, title, kind, finished, began, resumed_at_steps, total_steps; step, stage and atoms of the
/// newest whole checkpoint (null without one); damaged, a list of what is wrong with others; files, name and bytes.
[[nodiscard]] std::string directory_json(const std::filesystem::path& directory);

}  // namespace ljmd
