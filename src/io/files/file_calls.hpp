#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <optional>

#include "io/files/open_directory.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

/// The error "cannot open 'a.txt': Permission denied".
/// @param doing  "open"
/// @param error  value of errno
[[nodiscard]] FileError file_error(const char* doing, const std::filesystem::path& path, int error);

/// fsync, repeated when a signal interrupts it. Files that cannot be synchronised (pipes, devices, files of some
/// network file systems) are no error. @return 0 or the error number
[[nodiscard]] int sync_descriptor(int descriptor);

/// The status of the file of this name, links not followed; nothing when there is none.
/// @throws FileError when this cannot be determined
[[nodiscard]] std::optional<struct stat> status_of(const OutputPlace& place);

[[nodiscard]] bool is_same_file(const struct stat& a, const struct stat& b);

}  // namespace ljmd
