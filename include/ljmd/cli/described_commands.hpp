#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "ljmd/cli/pages/command_tree.hpp"

namespace ljmd {

// What the program needs of its parser; the library does not know CLI11.

/// Help in lines that fit the screen.
[[nodiscard]] std::shared_ptr<CLI::Formatter> screen_formatter();

[[nodiscard]] std::vector<const CLI::App*> commands_of(const CLI::App& app);

/// The commands and options of a parser.
[[nodiscard]] CommandTree command_tree(const CLI::App& app, const std::string& version);

/// Message for a word that is no command, with the nearest one.
[[nodiscard]] std::string unknown_command(const CLI::App& app, const std::string& word);

/// Report a wrong command line. @return the exit code, 2
[[nodiscard]] int report_usage(const CLI::App& app, const CLI::ParseError& error);

}  // namespace ljmd
