#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ljmd {

// Checks of every command before it writes, so that nothing is replaced without permission.

/// The files and links in a directory that have one of these names.
/// @param consequence  what was not done, for the message of a refusal: "Nothing was run"
/// @throws InputError  the path is not a directory or too long to name files in it, or one of the names belongs to
/// something other than a file or link, such as a directory or a pipe
[[nodiscard]] std::vector<std::filesystem::path> existing_outputs(const std::filesystem::path& directory,
                                                                  const std::vector<std::string>& names,
                                                                  const std::string& consequence);

/// Refuse to replace files without `force`.
/// @throws InputError  one of the names exists, or as existing_outputs()
void require_no_outputs(const std::filesystem::path& directory, const std::vector<std::string>& names, bool force,
                        const std::string& consequence);

/// Refuse to write into the directory of a run, whose files must not change. @throws InputError
void require_no_run(const std::filesystem::path& directory, const std::string& consequence);

}  // namespace ljmd
