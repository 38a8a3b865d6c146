#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "ljmd/core/errors.hpp"
#include "ljmd/core/types.hpp"

namespace ljmd {

/// A run was stopped from outside between two steps, after writing a checkpoint. The text says how to resume it.
class Interrupted : public Error {
  public:
    Interrupted(const std::string& text, int exit_code) : Error(text), exit_code_(exit_code) {}
    [[nodiscard]] int exit_code() const { return exit_code_; }

  private:
    int exit_code_;
};

/// A signal that asks the program to stop.
struct StopRequest {
    int signal;
    std::string name;  ///< "SIGTERM"

    /// 128 + n, as in a shell.
    [[nodiscard]] int exit_code() const;
};

/// Returns the request to stop, if there is one. Called after every step.
using AskedToStop = std::function<std::optional<StopRequest>()>;

/// Reasons to stop a run before its end: a request, or the end of its wall time.
class Interruption {
  public:
    /// @param walltime  [s] from now; none: no limit
    /// @param asked     none: no requests
    explicit Interruption(std::optional<double> walltime = std::nullopt, AskedToStop asked = {});

    [[nodiscard]] std::optional<StopRequest> request() const { return asked_ ? asked_() : std::nullopt; }
    [[nodiscard]] bool wanted() const { return request().has_value() || time_is_over(); }

    /// @pre wanted(), and a checkpoint has been written
    /// @throws Interrupted
    [[noreturn]] void stop(Index step, const std::string& directory) const;

    /// End a command that starts many runs, after all of them have stopped. @pre wanted()  @throws Interrupted
    [[noreturn]] void stop_many_runs() const;

  private:
    using Clock = std::chrono::steady_clock;
    [[nodiscard]] bool time_is_over() const { return end_ && Clock::now() >= *end_; }

    std::optional<Clock::time_point> end_;
    AskedToStop asked_;
};

}  // namespace ljmd
