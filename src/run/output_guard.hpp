#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/files/output_file.hpp"
#include "io/files/replacement_file.hpp"
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

inline constexpr std::pair<const char*, const char*> another_name{"choose another name", ""};

/// What a file that is written under a given name may take the place of.
struct Replacing {
    /// Any file or link. A link is replaced itself, never what it leads to.
    bool force = false;
    /// Files that ljmd wrote: this text stands in their first 4 KiB. Empty: none.
    std::string_view mark = {};
    // For the message of a refusal.
    std::string consequence = "Nothing was written";
    std::pair<const char*, const char*> instead = another_name;
};

/// Refuse a file that must not be written. Changes nothing. For commands that compute long before they write.
/// @throws OutputRefused  a file or link is there that may not be replaced, or something else: a directory, a pipe, a
/// device, a link to one of these
void require_writable(const std::filesystem::path& file, const Replacing& allowed);

/// The one door for files outside of directories that a command has locked: a file grows beside the place that it is
/// given, and takes it when it is complete. See ReplacementFile for what a failure leaves: the old file, and no other.
class NamedOutput {
  public:
    /// @throws OutputRefused as require_writable(); FileError
    NamedOutput(const std::filesystem::path& file, Replacing allowed);

    /// Where it grows.
    [[nodiscard]] const ReplacementFile& growing() const { return growing_; }

    /// Move it to its place. @pre the file was synchronised
    /// @throws OutputRefused when something else has been put there meanwhile; FileError
    void take_place();

  private:
    Replacing allowed_;
    ReplacementFile growing_;
};

/// Write a file through a NamedOutput. @throws as NamedOutput, and whatever `fill` throws
void write_output(const std::filesystem::path& file, const Replacing& allowed,
                  const std::function<void(OutputFile&)>& fill);
void write_output(const std::filesystem::path& file, const Replacing& allowed, std::string_view text);

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
