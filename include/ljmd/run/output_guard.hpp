#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "ljmd/core/errors.hpp"

namespace ljmd {

/// What cannot be written where it was asked for, and what to choose instead. Whoever has no command line is not told
/// of its options.
class OutputRefused : public InputError {
  public:
    /// What can be done instead, and how a command is told to: {"choose another directory", " with --out"}.
    using Choices = std::vector<std::pair<std::string, std::string>>;

    OutputRefused(const std::string& why, const Choices& choices);

    /// what() with the options of a command.
    [[nodiscard]] const std::string& for_commands() const { return for_commands_; }

  private:
    std::string for_commands_;
};

inline constexpr std::pair<const char*, const char*> another_directory{"choose another directory", " with --out"};

/// The name of a directory that is made for outputs: `name` and `ending`. Of a name that is too long with it for a file
/// system, the end is left out.
[[nodiscard]] std::string output_name(std::string name, const std::string& ending);

// Checks of every command before it writes, so that nothing is replaced without permission.

/// The files and links in a directory that have one of these names.
/// @param consequence  what was not done, for the message of a refusal: "Nothing was run"
/// @throws OutputRefused  the path is not a directory or too long to name files in it, or one of the names belongs to
/// something other than a file or link, such as a directory or a pipe
[[nodiscard]] std::vector<std::filesystem::path> existing_outputs(const std::filesystem::path& directory,
                                                                  const std::vector<std::string>& names,
                                                                  const std::string& consequence);

/// Refuse to replace files without `force`.
/// @throws OutputRefused  one of the names exists, or as existing_outputs()
void require_no_outputs(const std::filesystem::path& directory, const std::vector<std::string>& names, bool force,
                        const std::string& consequence);

/// Refuse to write into the directory of a run, whose files must not change. @throws OutputRefused
void require_no_run(const std::filesystem::path& directory, const std::string& consequence);

}  // namespace ljmd
