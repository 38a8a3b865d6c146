#pragma once

#include <string>

#include "cli/pages/command_tree.hpp"

namespace ljmd {

/// The manual page ljmd(1) in the macros of man(7): all commands with their options, exit codes, environment, files and
/// examples.
[[nodiscard]] std::string man_page(const CommandTree& tree);

}  // namespace ljmd
