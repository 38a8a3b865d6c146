#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

/// File system calls other than reading (input_file.hpp) and writing (output_file.hpp). Operations of std::filesystem
/// throw exceptions that no caller expects, or report errors that are easily overlooked. These functions throw a
/// FileError with path and cause. `tests/lints/check_file_calls.py` finds direct uses of std::filesystem.
namespace ljmd::files {

/// Whether a file or directory exists, links followed. @throws FileError when this cannot be determined
[[nodiscard]] bool exists(const std::filesystem::path& path);

/// Whether the name exists, even as a broken link. @throws FileError when this cannot be determined
[[nodiscard]] bool is_taken(const std::filesystem::path& path);

/// Whether the path, or a name in it, is longer than the system allows.
[[nodiscard]] bool is_too_long(const std::filesystem::path& path);

/// The type of the file, links not followed; `not_found` when there is none.
/// @throws FileError when this cannot be determined
[[nodiscard]] std::filesystem::file_type type_of(const std::filesystem::path& path);

/// Whether something other than a directory exists there, links followed.
/// @throws FileError when this cannot be determined
[[nodiscard]] bool is_no_directory(const std::filesystem::path& path);

/// True for a directory or a link to one. @throws FileError when this cannot be determined
[[nodiscard]] bool is_directory(const std::filesystem::path& path);

/// True for a regular file or a link to one. @throws FileError when this cannot be determined
[[nodiscard]] bool is_regular_file(const std::filesystem::path& path);

/// Size of a regular file in bytes; nothing when it is missing or not regular. @throws FileError
[[nodiscard]] std::optional<std::uintmax_t> size_of(const std::filesystem::path& path);

/// Whether two paths lead to the same file. False when one of them is missing.
/// @throws FileError when this cannot be determined
[[nodiscard]] bool are_same(const std::filesystem::path& one, const std::filesystem::path& other);

/// The entries of a folder as FOLDER/NAME, sorted by name. @throws FileError
[[nodiscard]] std::vector<std::filesystem::path> list(const std::filesystem::path& folder);

/// The absolute path; an empty path stays empty.
/// @throws FileError when the working directory no longer exists
[[nodiscard]] std::filesystem::path absolute(const std::filesystem::path& path);

/// The absolute path without links, '.' and '..', and without a slash at its end, the same for each path that leads to
/// the place; what does not exist yet stays as it is given. @throws FileError
[[nodiscard]] std::filesystem::path canonical(const std::filesystem::path& path);

/// The target of a link. @throws FileError
[[nodiscard]] std::filesystem::path read_link(const std::filesystem::path& path);

/// The directory for temporary files: TMPDIR, or /tmp. @throws FileError when there is none
[[nodiscard]] std::filesystem::path temporary_folder();

/// Create a directory and its parents; no error if it exists. @throws FileError
void create_directories(const std::filesystem::path& directory);

/// Remove a file, a link or an empty directory; no error if it is missing. @throws FileError
void remove(const std::filesystem::path& path);

/// As remove(), but errors are ignored: for files that do no harm if they stay.
void try_to_remove(const std::filesystem::path& path) noexcept;

/// Remove a directory and its contents; errors are ignored.
void try_to_remove_all(const std::filesystem::path& directory) noexcept;

/// Rename a file, replacing any file of the new name. @throws FileError
void rename(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace ljmd::files
