#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "ljmd/io/files/open_directory.hpp"
#include "ljmd/io/files/output_file.hpp"

namespace ljmd {

/// A new file that is to take the place of another one, or of none: it grows in the same directory under a name that
/// nothing has, `.ljmd-` and a random number, so that no file of others is written to, replaced or removed. In a
/// directory that is held alone the name begins with `.ljmd-locked-`. Removed at the end of the scope unless it has
/// taken its place; when the program is killed it stays, see remove_left_over().
class ReplacementFile {
  public:
    /// Makes the file, empty. @throws FileError
    explicit ReplacementFile(OutputPlace place);
    ~ReplacementFile();
    ReplacementFile(const ReplacementFile&) = delete;
    ReplacementFile& operator=(const ReplacementFile&) = delete;

    /// Where it grows.
    [[nodiscard]] const OutputPlace& growing() const { return growing_; }

    /// Where it is to lie.
    [[nodiscard]] const OutputPlace& place() const { return place_; }

    /// From now on it lies in its place: rename, fsync of the folder. @pre it is on the disk  @throws FileError
    void take_place();

  private:
    OutputPlace place_;
    OutputPlace growing_;
    bool taken_ = false;
};

/// Remove the files that a program which held the directory alone was about to put in their places when it was killed.
/// @pre the directory is held alone
void remove_left_over(const OpenDirectory& directory);

/// Write a whole file so that a reader finds either the old one or the new one: see ReplacementFile. On failure there
/// is what was there before.
/// @throws FileError, and whatever `fill` throws
void write_file_atomically(const OutputPlace& place, const std::function<void(OutputFile&)>& fill);
void write_file_atomically(const OutputPlace& place, std::string_view text);

}  // namespace ljmd
