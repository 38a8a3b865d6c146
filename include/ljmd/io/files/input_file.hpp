#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace ljmd {

/// Why there is nothing to read at a path, "no such file" or "is a pipe, not a regular file"; empty when there is.
///
/// Only regular files are read, or links to them: opening a pipe may wait for ever, a device may have no end, and of
/// the files that the kernel makes up below /proc and /sys some do either.
[[nodiscard]] std::string why_unreadable(const std::filesystem::path& path);

/// Whether an input is there, if only a link that leads nowhere. @throws DataError when that cannot be told
[[nodiscard]] bool input_is_there(const std::filesystem::path& path);

/// Open a file to be read.
/// @return why not, as why_unreadable() has it; empty when it is open
[[nodiscard]] std::string open_input(const std::filesystem::path& path, std::ifstream& file);

/// @throws DataError naming the path, when it is not a regular file or cannot be opened
[[nodiscard]] std::ifstream open_input(const std::filesystem::path& path);

/// All bytes of a file. @throws DataError naming the path, when it is not a regular file or cannot be read to its end
[[nodiscard]] std::string read_input(const std::filesystem::path& path);

/// Why the last reading of a stream failed, to be asked at once: "cannot be read: Input/output error".
[[nodiscard]] std::string why_reading_failed();

/// What a file is that does not begin as a text does: HDF5, compressed, text in UTF-16, or lines that end in CR alone.
/// Empty for a text, and for what is unknown.
/// @param beginning  its first bytes
[[nodiscard]] std::string why_no_text(std::string_view beginning);

}  // namespace ljmd
