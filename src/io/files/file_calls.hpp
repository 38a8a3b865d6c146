#pragma once

#include <sys/stat.h>

#include <filesystem>

#include "ljmd/core/errors.hpp"

namespace ljmd {

/// The error "cannot open 'a.txt': Permission denied".
/// @param doing  "open"
/// @param error  value of errno
[[nodiscard]] FileError file_error(const char* doing, const std::filesystem::path& path, int error);

/// fsync, repeated when a signal interrupts it. Files that cannot be synchronised (pipes, devices, files of some
/// network file systems) are no error. @return 0 or the error number
[[nodiscard]] int sync_descriptor(int descriptor);

[[nodiscard]] bool is_same_file(const struct stat& a, const struct stat& b);

}  // namespace ljmd
