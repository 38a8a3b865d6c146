#pragma once

#include <filesystem>

namespace ljmd {

/// Keeps other runs out of a directory while it lives; a program that is killed leaves nothing behind. Of a file system
/// that knows no such locks nothing is asked.
class DirectoryLock {
  public:
    /// @pre the directory exists
    /// @throws InUseError when another run has it  @throws FileError when it cannot be opened
    explicit DirectoryLock(const std::filesystem::path& directory);
    ~DirectoryLock();
    DirectoryLock(const DirectoryLock&) = delete;
    DirectoryLock& operator=(const DirectoryLock&) = delete;

    /// Whether another has it now.
    [[nodiscard]] static bool is_held(const std::filesystem::path& directory);

  private:
    int descriptor_;
};

}  // namespace ljmd
