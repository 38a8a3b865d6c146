#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/pages/command_tree.hpp"

namespace ljmd {

/// The command line of the program: its parser, and all commands.
class CommandLine {
  public:
    CommandLine();
    CommandLine(const CommandLine&) = delete;
    CommandLine& operator=(const CommandLine&) = delete;

    [[nodiscard]] const CLI::App& parser() const { return parser_; }

    /// Read the words behind the name of the program. @throws CLI::ParseError, also where help is asked for
    void parse(std::vector<std::string> words);

    /// Do what they ask for. @pre parse()  @throws the typed errors of core/errors.hpp
    void run();

  private:
    CLI::App parser_;
    std::vector<std::shared_ptr<Command>> commands_;  ///< in the order of the parser's
};

/// The program: do what the words behind its name ask for, and report what stands in the way.
/// @return the exit code
[[nodiscard]] int run_command_line(std::vector<std::string> words);

/// The commands and options of the program's parser, without those that are hidden.
[[nodiscard]] CommandTree command_tree(const CLI::App& program);

/// Message for a word that is no command, with the nearest one.
[[nodiscard]] std::string unknown_command(const CLI::App& program, const std::string& word);

}  // namespace ljmd
