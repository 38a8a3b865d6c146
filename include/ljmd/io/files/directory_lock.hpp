#pragma once

#include <filesystem>

#include "ljmd/io/files/open_directory.hpp"

namespace ljmd {

/// Keeps other runs out of a directory while it lives; a program that is killed leaves no lock behind. Of a file system
/// that knows no such locks nothing is asked, nor of a directory that may not be read.
class DirectoryLock {
  public:
    /// Removes, too, what a holder of the lock that was killed has left over (see ReplacementFile).
    /// @throws InUseError when another run has it  @throws FileError when it cannot be opened
    explicit DirectoryLock(const OpenDirectory& directory);

    /// The directory that is locked, whatever stands at its path by now; held alone, unless the file system knows no
    /// locks.
    [[nodiscard]] const OpenDirectory& directory() const { return directory_; }

    /// Whether another has it now: not of what is no directory, or is one that may not be read.
    /// @throws FileError when it cannot be opened for another reason
    [[nodiscard]] static bool is_held(const std::filesystem::path& directory);

  private:
    OpenDirectory directory_;
};

}  // namespace ljmd
