#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "io/files/open_directory.hpp"

namespace ljmd {

/// A file that one process at a time writes to, such as the log of a run. It is claimed by a lock (flock) that belongs
/// to the open file: a child process that has it as its standard output holds the claim, too, and keeps it if its
/// parent is killed. A killed process leaves no claim behind.
///
/// Other than a lock on a directory, a lock on a file is seen from all computers of most network file systems. Where
/// the file system has no locks, every claim is granted.
class ClaimedFile {
  public:
    /// Claim a file, which is created if it is missing. Links are not followed.
    /// @return nothing when another process holds it  @throws FileError
    [[nodiscard]] static std::optional<ClaimedFile> claim(const std::filesystem::path& path);

    /// Whether a process holds a file now. False for a path that is missing, no regular file or not readable.
    /// @throws FileError when it cannot be opened for another reason
    [[nodiscard]] static bool is_held(const std::filesystem::path& path);

    /// For a child process; what is written goes to the end of the file.
    [[nodiscard]] int descriptor() const { return *descriptor_; }

    /// Remove what is in it. @throws FileError
    void clear() const;

    /// Write a text at its end. @throws FileError
    void append(const std::string& text) const;

  private:
    ClaimedFile(std::filesystem::path path, int descriptor);

    std::filesystem::path path_;
    std::shared_ptr<const int> descriptor_;
};

/// Shows that a directory is in use, together with others that show it. A DirectoryLock on it is refused meanwhile.
/// Does nothing where the file system has no locks or the directory is not readable.
class SharedDirectory {
  public:
    /// @throws InUseError when a process holds a DirectoryLock on it
    explicit SharedDirectory(OpenDirectory directory);

    [[nodiscard]] const OpenDirectory& directory() const { return directory_; }

  private:
    OpenDirectory directory_;
};

}  // namespace ljmd
