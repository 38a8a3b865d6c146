#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "ljmd/cli/commands.hpp"

namespace ljmd {

/// The commands about the program itself, and the one to begin with: init, help, version, verify, completion.
class OwnCommands {
  public:
    /// Add the commands to a parser, which must live as long as this.
    explicit OwnCommands(CLI::App& app);
    OwnCommands(const OwnCommands&) = delete;
    OwnCommands& operator=(const OwnCommands&) = delete;

    /// Whether the command line has one of them.
    [[nodiscard]] bool parsed() const;

    /// Run it. @return the exit code
    [[nodiscard]] int run() const;

  private:
    [[nodiscard]] int help() const;
    [[nodiscard]] int verify() const;

    const CLI::App& app_;
    const CLI::App& init_;
    const CLI::App& help_;
    const CLI::App& version_;
    const CLI::App& verify_;
    const CLI::App& completion_;
    InitOptions begun_;
    std::string command_;  ///< to print help on; empty: all
    bool man_ = false;
    std::string shell_;
    int threads_ = 0;   ///< 0: by default
    std::string simd_;  ///< empty: by default
    bool json_ = false;
};

}  // namespace ljmd
