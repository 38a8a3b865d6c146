#pragma once

#include <CLI/CLI.hpp>

#include "ljmd/cli/commands.hpp"

namespace ljmd {

/// `ljmd sweep` on the command line.
class SweepCommand {
  public:
    /// Add the command to a parser, which must live as long as this.
    explicit SweepCommand(CLI::App& app);
    SweepCommand(const SweepCommand&) = delete;
    SweepCommand& operator=(const SweepCommand&) = delete;

    /// Whether the command line has it.
    [[nodiscard]] bool parsed() const { return command_.parsed(); }
    void run() const { sweep_command(options_); }

  private:
    CLI::App& command_;
    SweepOptions options_;
};

}  // namespace ljmd
