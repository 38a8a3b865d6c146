#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "ljmd/core/errors.hpp"
#include "ljmd/core/types.hpp"

namespace ljmd {

/// A run was stopped from outside, between two steps and with a checkpoint written. The text tells how to go on.
class Interrupted : public Error {
  public:
    Interrupted(const std::string& text, int exit_code) : Error(text), exit_code_(exit_code) {}
    [[nodiscard]] int exit_code() const { return exit_code_; }

  private:
    int exit_code_;
};

/// Undo what a parent may have left to this program: a mask that keeps signals from it for ever, and SIGCHLD, SIGTERM,
/// SIGUSR1 and SIGXCPU ignored. Without SIGCHLD no child could be waited for. SIGINT and SIGHUP stay ignored where they
/// are: so nohup and shells keep a terminal's keys and its end from a program. @pre no threads yet
void forget_inherited_signals();

/// From now on SIGINT, SIGHUP, SIGTERM, SIGUSR1 and SIGXCPU ask the program to stop, where they are not ignored. The
/// second SIGINT, SIGHUP or SIGTERM ends it at once; the other two, which queues and the system repeat, do not.
void heed_signals();

/// The signal that has asked to stop; 0: none.
[[nodiscard]] int signal_received();

/// The exit code of a program that a signal has stopped: 128 + n, as a shell says it.
[[nodiscard]] int signal_exit_code(int signal);

/// End a command that makes many runs, when all of them have stopped. @pre signal_received() != 0  @throws Interrupted
[[noreturn]] void stop_many_runs();

/// Why a run has to stop before its end: a signal, or that its time is over.
class Interruption {
  public:
    /// @param walltime  [s] from now; none: no limit
    explicit Interruption(std::optional<double> walltime = std::nullopt);

    [[nodiscard]] bool wanted() const { return signal_received() != 0 || time_is_over(); }

    /// @pre wanted(), and a checkpoint has been written
    /// @throws Interrupted
    [[noreturn]] void stop(Index step, const std::string& directory) const;

  private:
    using Clock = std::chrono::steady_clock;
    [[nodiscard]] bool time_is_over() const { return end_ && Clock::now() >= *end_; }

    std::optional<Clock::time_point> end_;
};

}  // namespace ljmd
