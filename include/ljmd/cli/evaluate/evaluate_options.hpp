#pragma once

#include <CLI/CLI.hpp>

#include "ljmd/cli/evaluate/evaluate_command.hpp"

namespace ljmd {

/// The command on the command line.
class EvaluateCommand {
  public:
    /// Add the command to a parser, which must live as long as this.
    explicit EvaluateCommand(CLI::App& app);
    EvaluateCommand(const EvaluateCommand&) = delete;
    EvaluateCommand& operator=(const EvaluateCommand&) = delete;

    /// Whether the command line has it.
    [[nodiscard]] bool parsed() const { return command_.parsed(); }
    void run() const { evaluate_command(options_); }

  private:
    CLI::App& command_;
    EvaluateOptions options_;
};

}  // namespace ljmd
