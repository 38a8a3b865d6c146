#pragma once

#include <filesystem>
#include <memory>
#include <string>

namespace ljmd {

struct OutputPlace;

/// A directory that is held open. Files in it are made, replaced and removed through its descriptor, so they go where
/// the directory is, whatever becomes of its path: it may be renamed, and something else may stand there. Copies share
/// the descriptor.
class OpenDirectory {
  public:
    /// Not explicit: a function that writes into a directory can be given its path.
    /// @param path  empty: the working directory
    /// @throws FileError
    OpenDirectory(const std::filesystem::path& path);

    /// The place of this name in it.
    [[nodiscard]] OutputPlace operator/(const std::string& name) const;

    /// A directory in this one, held alone like it. It is made if it is not there, and not reached through a link.
    /// @throws FileError
    [[nodiscard]] OpenDirectory made_within(const std::string& name) const;

    /// The same directory, of which is known that no other process works in it while this one does: see DirectoryLock.
    [[nodiscard]] OpenDirectory held_alone() const;
    [[nodiscard]] bool is_held_alone() const { return held_alone_; }

    /// Where it was when it was opened.
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] int descriptor() const { return *descriptor_; }

    /// Whether its path still leads to it. @throws FileError when that cannot be told
    [[nodiscard]] bool is_at_its_path() const;

    /// @throws InUseError unless its path still leads to it; FileError when that cannot be told
    void require_at_its_path() const;

    /// The names of the files in it are on the disk. @throws FileError
    void sync() const;

  private:
    friend struct OutputPlace;
    /// @param doing, what  for the message of an error
    OpenDirectory(std::filesystem::path path, const char* doing, const std::filesystem::path& what);
    OpenDirectory(std::filesystem::path path, int descriptor);

    std::filesystem::path path_;
    std::shared_ptr<const int> descriptor_;
    bool held_alone_ = false;
};

/// A name in an open directory: where a file is to lie.
struct OutputPlace {
    /// Opens the directory that the path names. Not explicit: a function that writes a file can be given its path.
    /// @throws FileError
    OutputPlace(const std::filesystem::path& path);
    OutputPlace(OpenDirectory in, std::string called);

    /// For messages, and for libraries that know paths alone.
    [[nodiscard]] std::filesystem::path path() const { return directory.path() / name; }

    /// Whether the open file of this descriptor has this name.
    [[nodiscard]] bool holds(int descriptor) const;

    OpenDirectory directory;
    std::string name;
};

}  // namespace ljmd
