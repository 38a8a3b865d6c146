#pragma once

#include <sys/types.h>

#include <csignal>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ljmd/core/errors.hpp"

namespace ljmd {

/// Another program and what it is to do.
struct Process {
    std::filesystem::path program;  ///< as find_program gave it
    std::vector<std::string> arguments{};
    std::filesystem::path directory;  ///< where it runs
    std::filesystem::path output;     ///< file that takes its stdout and stderr; a relative one lies in `directory`
    std::vector<std::pair<std::string, std::string>> environment{};  ///< set for it, beside what this process has
    bool own_group = false;  ///< keys on the terminal (Ctrl-C) do not reach it; who started it tells it to stop
    /// The signal that it gets when the thread that started it ends first, however that ends; 0: none. On Linux; other
    /// systems know nothing of the kind.
    int at_our_end = SIGKILL;
    int input = -1;  ///< descriptor that it reads as stdin; -1: its stdin is empty
};

/// The system refuses another process, for lack of memory or because of a limit.
class ProcessesError : public Error {
  public:
    using Error::Error;
};

/// The file that a name means, as a shell finds it: a name with a slash is itself, every other one is looked for in the
/// directories of PATH. @return absolute; nothing when there is no such file or it may not be executed
[[nodiscard]] std::optional<std::filesystem::path> find_program(const std::string& name);

/// A program that runs beside this one. Its signals are handled in the usual way and none is blocked, but those that
/// this process was told to ignore stay so.
class ChildProcess {
  public:
    /// Start it without a shell between.
    /// @throws FileError  it cannot be started, or the output cannot be made  @throws ProcessesError
    explicit ChildProcess(const Process& process);

    /// Its exit status, 128 + n when signal n ended it; nothing while it runs. @throws FileError
    [[nodiscard]] std::optional<int> ended() { return wait(false); }

    /// Wait for its end. @return as ended()
    [[nodiscard]] int wait() { return *wait(true); }

    /// Send it a signal, if it still runs.
    void signal(int number) const;

  private:
    std::optional<int> wait(bool block);

    std::string name_;
    pid_t id_ = 0;
    std::optional<int> status_;
};

/// Run a program to its end.
/// @return its exit status; 128 + n when signal n ended it
/// @throws FileError, ProcessesError  as ChildProcess
[[nodiscard]] int run_process(const Process& process);

}  // namespace ljmd
