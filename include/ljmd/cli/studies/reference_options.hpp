#pragma once

#include <CLI/CLI.hpp>

#include "ljmd/cli/studies/reference_command.hpp"

namespace ljmd {

/// `ljmd reference` on the command line.
class ReferenceCommand {
  public:
    /// Add the command to a parser, which must live as long as this.
    explicit ReferenceCommand(CLI::App& app);
    ReferenceCommand(const ReferenceCommand&) = delete;
    ReferenceCommand& operator=(const ReferenceCommand&) = delete;

    /// Whether the command line has it.
    [[nodiscard]] bool parsed() const { return command_.parsed(); }
    void run() const { reference_command(options_); }

  private:
    CLI::App& command_;
    ReferenceOptions options_;
};

}  // namespace ljmd
