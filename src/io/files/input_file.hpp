#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace ljmd {

/// Why a path cannot be read, "no such file" or "is a pipe, not a regular file"; empty when it can.
///
/// Only regular files and links to them are read. Opening a pipe may block, a device may have no end, and some files of
/// /proc and /sys behave like either.
[[nodiscard]] std::string why_unreadable(const std::filesystem::path& path);

/// Whether an input exists, even as a broken link. @throws DataError when this cannot be determined
[[nodiscard]] bool input_is_there(const std::filesystem::path& path);

/// Whether an input is a directory or a link to one. @throws DataError when this cannot be determined
[[nodiscard]] bool input_is_directory(const std::filesystem::path& path);

/// Open a file for reading.
/// @return why it cannot be opened, worded as by why_unreadable(); empty on success
[[nodiscard]] std::string open_input(const std::filesystem::path& path, std::ifstream& file);

/// As above. @throws DataError with the path, when it is not a regular file or cannot be opened
[[nodiscard]] std::ifstream open_input(const std::filesystem::path& path);

/// All bytes of a file. @throws DataError with the path, when it is not a regular file or cannot be read to its end
[[nodiscard]] std::string read_input(const std::filesystem::path& path);

/// Go to a place in a stream. If that fails the stream is bad(), as after a read that failed.
void go_to(std::istream& stream, std::streamoff place);

/// Why the last read from a stream failed: "cannot be read: Input/output error". Call it at once: it reads errno.
[[nodiscard]] std::string why_reading_failed();

/// What a file is whose beginning is not text: HDF5, compressed, UTF-16, or lines that end in CR alone. Empty for text
/// and for unknown formats.
/// @param beginning  the first bytes of the file
[[nodiscard]] std::string why_no_text(std::string_view beginning);

}  // namespace ljmd
