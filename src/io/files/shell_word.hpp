#pragma once

#include <filesystem>
#include <string>

namespace ljmd {

/// A path as one word of a command, for a shell or for a user who copies it: in single quotes if a character of it has
/// a meaning for shells, and behind "./" where it would be read as an option.
[[nodiscard]] std::string shell_word(const std::filesystem::path& path);

}  // namespace ljmd
