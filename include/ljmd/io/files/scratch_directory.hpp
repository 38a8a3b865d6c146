#pragma once

#include <filesystem>
#include <optional>

#include "ljmd/io/files/pipe.hpp"
#include "ljmd/io/files/process.hpp"

namespace ljmd {

/// A new directory among the temporary files of the system, removed with all that is in it at the end of the scope; or,
/// when this program is ended before, even by SIGKILL, by a shell that waits for that.
class ScratchDirectory {
  public:
    /// @throws FileError when it cannot be made, or the system names no directory for temporary files
    /// @throws ProcessesError
    ScratchDirectory();
    ~ScratchDirectory();
    ScratchDirectory(const ScratchDirectory&) = delete;
    ScratchDirectory& operator=(const ScratchDirectory&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    Pipe life_;  ///< its writer is this program
    std::filesystem::path path_;
    std::optional<ChildProcess> remover_;
};

}  // namespace ljmd
