#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

/// What the program asks of the file system, beside reading (input_file.hpp) and writing (output_file.hpp). An
/// operation of std::filesystem throws what nobody expects, or reports an error that is easily lost. These throw a
/// FileError with the path and the cause; `tests/lints/check_file_calls.py` finds what goes past them.
namespace ljmd::files {

/// Whether something is there, at the end of all links. @throws FileError when that cannot be told
[[nodiscard]] bool exists(const std::filesystem::path& path);

/// Whether the name is taken, if only by a link that leads nowhere. @throws FileError when that cannot be told
[[nodiscard]] bool is_taken(const std::filesystem::path& path);

/// Whether the system has no room for so long a path, or name in it.
[[nodiscard]] bool is_too_long(const std::filesystem::path& path);

/// What the name stands for, links not followed; `not_found` when there is nothing. @throws FileError when that cannot
/// be told
[[nodiscard]] std::filesystem::file_type type_of(const std::filesystem::path& path);

/// Whether what is there, at the end of all links, is no directory. @throws FileError when that cannot be told
[[nodiscard]] bool is_no_directory(const std::filesystem::path& path);

/// True for a directory and a link to one. False also where that cannot be told: opening it will say why.
[[nodiscard]] bool is_directory(const std::filesystem::path& path);

/// True for a regular file and a link to one. False also where that cannot be told: opening it will say why.
[[nodiscard]] bool is_regular_file(const std::filesystem::path& path);

/// Bytes in a regular file; nothing for what is none, or is not there (any more). @throws FileError
[[nodiscard]] std::optional<std::uintmax_t> size_of(const std::filesystem::path& path);

/// Whether two names are of one file. False when one of them is not there. @throws FileError when that cannot be told
[[nodiscard]] bool are_same(const std::filesystem::path& one, const std::filesystem::path& other);

/// All that is in a folder, as FOLDER/NAME, in the order of the names. @throws FileError
[[nodiscard]] std::vector<std::filesystem::path> list(const std::filesystem::path& folder);

/// A path that does not depend on the working directory; an empty one stays empty.
/// @throws FileError when the working directory is not there any more
[[nodiscard]] std::filesystem::path absolute(const std::filesystem::path& path);

/// What a link says. @throws FileError
[[nodiscard]] std::filesystem::path read_link(const std::filesystem::path& path);

/// The directory for temporary files: TMPDIR, or /tmp. @throws FileError when there is none
[[nodiscard]] std::filesystem::path temporary_folder();

/// Make a directory, and those that it lies in. Nothing when it is there. @throws FileError
void create_directories(const std::filesystem::path& directory);

/// Remove a file, a link or an empty directory. Nothing when it is not there. @throws FileError
void remove(const std::filesystem::path& path);

/// As remove(), or leave it where that fails: for what is in nobody's way.
void try_to_remove(const std::filesystem::path& path) noexcept;

/// Remove a directory with all that is in it, or leave what cannot be removed.
void try_to_remove_all(const std::filesystem::path& directory) noexcept;

/// Give a file another name; a file that has it is replaced. @throws FileError
void rename(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace ljmd::files
