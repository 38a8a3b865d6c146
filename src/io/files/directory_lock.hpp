#pragma once

#include <filesystem>

#include "io/files/open_directory.hpp"

namespace ljmd {

/// Keeps other runs out of a directory during its lifetime. A killed program leaves no lock behind. Does nothing where
/// the file system has no locks or the directory is not readable.
class DirectoryLock {
  public:
    /// Also removes the files that a killed holder of the lock left behind (see ReplacementFile).
    /// @throws InUseError when another run holds the lock  @throws FileError when the directory cannot be opened
    explicit DirectoryLock(const OpenDirectory& directory);

    /// The locked directory, even if its path now leads elsewhere. It is held alone unless it could not be locked.
    [[nodiscard]] const OpenDirectory& directory() const { return directory_; }

    /// Whether another process holds the lock now. False for a path that is missing, no directory or not readable.
    /// @throws FileError when it cannot be opened for another reason
    [[nodiscard]] static bool is_held(const std::filesystem::path& directory);

  private:
    OpenDirectory directory_;
};

}  // namespace ljmd
