#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace ljmd {

/// Why there is nothing to read at a path, "no such file" or "is a pipe, not a regular file"; empty when there is.
///
/// Only regular files are read, or links to them: opening a pipe may wait for ever, and a device may have no end.
[[nodiscard]] std::string why_unreadable(const std::filesystem::path& path);

/// @throws DataError naming the path, when it is not a regular file or cannot be opened
[[nodiscard]] std::ifstream open_input(const std::filesystem::path& path);

}  // namespace ljmd
