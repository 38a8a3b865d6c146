#pragma once

#include <filesystem>
#include <memory>
#include <string>

namespace ljmd {

struct OutputPlace;

/// A directory that is held open. Files in it are created, replaced and removed through its descriptor, so they go into
/// this directory even if it is renamed or something else takes its path. Copies share the descriptor.
class OpenDirectory {
  public:
    /// Implicit, so that a function that writes into a directory accepts its path.
    /// @param path  empty: the working directory
    /// @throws FileError
    OpenDirectory(const std::filesystem::path& path);

    /// The place of a file of this name in the directory.
    [[nodiscard]] OutputPlace operator/(const std::string& name) const;

    /// Open a subdirectory, creating it if needed; links are not followed. It is held alone if this directory is.
    /// @throws FileError
    [[nodiscard]] OpenDirectory made_within(const std::string& name) const;

    /// The same directory, marked as locked: no other process works in it while this one does. See DirectoryLock.
    [[nodiscard]] OpenDirectory held_alone() const;
    [[nodiscard]] bool is_held_alone() const { return held_alone_; }

    /// The path by which it was opened.
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] int descriptor() const { return *descriptor_; }

    /// Whether the path still leads to this directory. @throws FileError when this cannot be determined
    [[nodiscard]] bool is_at_its_path() const;

    /// @throws InUseError unless the path still leads to this directory; FileError when this cannot be determined
    void require_at_its_path() const;

    /// Synchronise the directory: the names of its files are then on the disk. @throws FileError
    void sync() const;

  private:
    friend struct OutputPlace;
    /// @param doing, what  for the error message
    OpenDirectory(std::filesystem::path path, const char* doing, const std::filesystem::path& what);
    OpenDirectory(std::filesystem::path path, int descriptor);

    std::filesystem::path path_;
    std::shared_ptr<const int> descriptor_;
    bool held_alone_ = false;
};

/// A file name in an open directory: where a file is or will be.
struct OutputPlace {
    /// Opens the directory of the path. Implicit, so that a function that writes a file accepts its path.
    /// @throws FileError
    OutputPlace(const std::filesystem::path& path);
    OutputPlace(OpenDirectory in, std::string called);

    /// The path, for messages and for libraries that only take paths.
    [[nodiscard]] std::filesystem::path path() const { return directory.path() / name; }

    /// Whether this name belongs to the open file of this descriptor. @throws FileError when this cannot be determined
    [[nodiscard]] bool holds(int descriptor) const;

    OpenDirectory directory;
    std::string name;
};

}  // namespace ljmd
