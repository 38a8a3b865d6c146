#pragma once

#include <string>

#include "ljmd/cli/pages/command_tree.hpp"

namespace ljmd {

/// The script by which a shell completes command lines of the program: commands, options, their values, keys of decks
/// behind --set, files. @param shell  "bash", "fish" or "zsh"  @throws InputError for another one
[[nodiscard]] std::string completion(const CommandTree& tree, const std::string& shell);

[[nodiscard]] std::string bash_completion(const CommandTree& tree);
[[nodiscard]] std::string fish_completion(const CommandTree& tree);
[[nodiscard]] std::string zsh_completion(const CommandTree& tree);

/// Dotted keys of all decks as --set takes them, sorted; "NAME" and "NUMBER" stand for an element of an array of
/// tables.
[[nodiscard]] std::vector<std::string> all_deck_keys();

}  // namespace ljmd
