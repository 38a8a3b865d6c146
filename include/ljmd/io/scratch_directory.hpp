#pragma once

#include <filesystem>

namespace ljmd {

/// A new directory among the temporary files of the system, removed with all that is in it at the end of the scope.
class ScratchDirectory {
  public:
    /// @throws FileError when it cannot be made, or the system names no directory for temporary files
    ScratchDirectory();
    ~ScratchDirectory();
    ScratchDirectory(const ScratchDirectory&) = delete;
    ScratchDirectory& operator=(const ScratchDirectory&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

}  // namespace ljmd
