#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "io/files/open_directory.hpp"
#include "io/files/output_file.hpp"

namespace ljmd {

/// A new file that will replace another one or fill a free name. It grows in the same directory under an unused name,
/// `.ljmd-` and a random number, so that no foreign file is written to, replaced or removed. In a directory that is
/// held alone the name begins with `.ljmd-locked-`. The destructor removes it unless it has taken its place. A killed
/// program leaves it behind; see remove_left_over().
class ReplacementFile {
  public:
    /// Create the empty file. @throws FileError
    explicit ReplacementFile(OutputPlace place);
    ~ReplacementFile();
    ReplacementFile(const ReplacementFile&) = delete;
    ReplacementFile& operator=(const ReplacementFile&) = delete;

    /// Where it grows.
    [[nodiscard]] const OutputPlace& growing() const { return growing_; }

    /// Where it will be.
    [[nodiscard]] const OutputPlace& place() const { return place_; }

    /// Move it to its place: rename, then fsync of the directory. @pre the file was synchronised  @throws FileError
    void take_place();

  private:
    OutputPlace place_;
    OutputPlace growing_;
    bool taken_ = false;
};

/// Remove the replacement files that a killed program left in a locked directory.
/// @pre the directory is held alone
void remove_left_over(const OpenDirectory& directory);

/// Write a whole file through a ReplacementFile, so that a reader finds either the old or the new one. On failure the
/// old one stays.
/// @throws FileError, and whatever `fill` throws
void write_file_atomically(const OutputPlace& place, const std::function<void(OutputFile&)>& fill);
void write_file_atomically(const OutputPlace& place, std::string_view text);

}  // namespace ljmd
