#pragma once

#include <CLI/CLI.hpp>

#include "ljmd/cli/commands.hpp"

namespace ljmd {

/// `ljmd reproduce` on the command line.
class ReproduceCommand {
  public:
    /// Add the command to a parser, which must live as long as this.
    explicit ReproduceCommand(CLI::App& app);
    ReproduceCommand(const ReproduceCommand&) = delete;
    ReproduceCommand& operator=(const ReproduceCommand&) = delete;

    /// Whether the command line has it.
    [[nodiscard]] bool parsed() const { return command_.parsed(); }
    void run() const { reproduce_command(options_); }

  private:
    CLI::App& command_;
    ReproduceOptions options_{.what = "", .out = "runs/verlet1967"};
};

}  // namespace ljmd
