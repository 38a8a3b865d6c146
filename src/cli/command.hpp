#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace ljmd {

/// A command of the program. Each is one file, src/cli/commands/x_command.cpp, which defines
/// `std::shared_ptr<Command> x_command()`. The program finds it by itself, and so do help, completion and man page.
class Command {
  public:
    /// Its place in the list of all commands.
    enum class Part { runs, studies, results, peers, program, hidden };

    /// @param meaning  what it does, in a line
    Command(std::string name, Part part, std::string meaning)
        : name_(std::move(name)), part_(part), meaning_(std::move(meaning)) {}
    Command(const Command&) = delete;
    Command& operator=(const Command&) = delete;
    virtual ~Command() = default;

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] Part part() const { return part_; }
    [[nodiscard]] const std::string& meaning() const { return meaning_; }

    /// Add its options and arguments to its parser, whose parent is the program's parser. They are kept in members.
    virtual void add_options(CLI::App& command) = 0;

    /// Whether processes that mpirun has started can share its work, with the options of the command line.
    [[nodiscard]] virtual bool shares_work() const { return false; }

    /// Do what the command line asks for: results go to stdout, messages to stderr.
    /// @throws the typed errors of core/errors.hpp
    virtual void run() = 0;

  private:
    std::string name_;
    Part part_;
    std::string meaning_;
};

/// All commands, sorted by the names of their files. Each call makes new ones.
[[nodiscard]] std::vector<std::shared_ptr<Command>> all_commands();

}  // namespace ljmd
