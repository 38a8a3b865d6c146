#pragma once

#include <sys/stat.h>

#include <filesystem>

#include "ljmd/core/errors.hpp"

namespace ljmd {

/// "cannot open 'a.txt': Permission denied".
/// @param doing  "open"
/// @param error  what errno tells
[[nodiscard]] FileError file_error(const char* doing, const std::filesystem::path& path, int error);

/// fsync, again after a signal. What cannot be synced (pipes, devices, files of some network file systems) is no
/// failure. @return 0 or the error number
[[nodiscard]] int sync_descriptor(int descriptor);

[[nodiscard]] bool is_same_file(const struct stat& a, const struct stat& b);

}  // namespace ljmd
