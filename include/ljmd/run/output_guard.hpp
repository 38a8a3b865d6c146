#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ljmd {

// What every command that writes asks before it begins, so that nothing is lost that it was not told to replace.

/// The files and links in a directory that have one of these names.
/// @param consequence  what was not done, when it is refused: "Nothing was run"
/// @throws InputError  the directory is none, its path is too long to name files in it, or one of the names is there
/// and
///                     is neither a file nor a link: a directory, a pipe
[[nodiscard]] std::vector<std::filesystem::path> existing_outputs(const std::filesystem::path& directory,
                                                                  const std::vector<std::string>& names,
                                                                  const std::string& consequence);

/// Refuse to replace files without `force`.
/// @throws InputError  one of the names is there, or as existing_outputs()
void require_no_outputs(const std::filesystem::path& directory, const std::vector<std::string>& names, bool force,
                        const std::string& consequence);

/// Refuse to write into the directory of a run, whose files stay as they are. @throws InputError
void require_no_run(const std::filesystem::path& directory, const std::string& consequence);

}  // namespace ljmd
