#pragma once

#include <filesystem>
#include <optional>

#include "io/files/pipe.hpp"
#include "io/files/process.hpp"

namespace ljmd {

/// A new directory for temporary files, removed with its contents at the end of the scope. If this program ends before
/// that, even by SIGKILL, a waiting shell removes it.
class ScratchDirectory {
  public:
    /// @throws FileError when it cannot be created, or the system has no directory for temporary files
    /// @throws ProcessesError
    ScratchDirectory();
    ~ScratchDirectory();
    ScratchDirectory(const ScratchDirectory&) = delete;
    ScratchDirectory& operator=(const ScratchDirectory&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    Pipe life_;  ///< the shell waits for its end: only this program holds the writing end
    std::filesystem::path path_;
    std::optional<ChildProcess> remover_;
};

}  // namespace ljmd
