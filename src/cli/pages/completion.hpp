#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/pages/command_tree.hpp"

namespace ljmd {

/// What the last word of a command line can be: one line for each possible word, with what it means behind a tab. A
/// word that ends in '=' wants more behind it. Where files are wanted, a line ":files", ":directories" or ":decks"
/// (which end in .toml) asks the shell for them.
/// @param words  those behind the name of the program; the last is the one to complete, and may be empty
[[nodiscard]] std::string completions(const CommandTree& tree, const std::vector<std::string>& words);

/// The shells that have a completion_script().
[[nodiscard]] std::vector<std::string> completed_shells();

/// The script by which a shell asks `ljmd complete` for completions(). @throws InputError for another shell
[[nodiscard]] std::string_view completion_script(const std::string& shell);

}  // namespace ljmd
