#pragma once

#include <sys/types.h>

#include <csignal>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/files/pipe.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

/// A program to start, with its arguments and surroundings.
struct Process {
    std::filesystem::path program;  ///< as returned by find_program
    std::vector<std::string> arguments{};
    std::filesystem::path directory;  ///< working directory
    std::filesystem::path output;     ///< file for its stdout and stderr; a relative path is relative to `directory`
    std::filesystem::path errors{};   ///< file for its stderr alone; empty: that goes where stdout goes
    std::vector<std::pair<std::string, std::string>> environment{};  ///< added to the environment of this process
    /// Variables are left out of the environment whose "NAME=value" begins with one of these, "NAME=" or "PREFIX_".
    std::vector<std::string> without{};
    bool own_group = false;  ///< a process group of its own: Ctrl-C does not reach it, the caller must stop it
    /// It runs, in a group of its own, below a keeper: a process that ends it and all of its descendants, also those
    /// that have left it, when it ends itself, when it is stopped, and when this process ends, for whatever reason.
    /// Linux only; who kills the keeper and this process in the same moment leaves descendants behind.
    bool kept = false;
    /// Signal sent to it (Linux only) when the thread that started it ends first, for whatever reason; 0: none.
    int at_our_end = SIGKILL;
    int input = -1;              ///< descriptor used as stdin; -1: empty stdin
    int output_descriptor = -1;  ///< used for its stdout and stderr instead of the file `output`; -1: the file
};

/// The system refuses to start another process, for lack of memory or because of a limit.
class ProcessesError : public Error {
  public:
    using Error::Error;
};

/// Find a program as a shell does: a name with a slash is a path, any other is searched for in the directories of PATH.
/// @return its absolute path; nothing when there is no such file or it is not executable  @throws FileError
[[nodiscard]] std::optional<std::filesystem::path> find_program(const std::string& name);

/// A running child process. It starts with default signal handlers and no blocked signals; signals that this process
/// was told to ignore stay ignored.
class ChildProcess {
  public:
    /// Start it, without a shell.
    /// @throws FileError  it cannot be started, or its output file cannot be created  @throws ProcessesError
    explicit ChildProcess(const Process& process);

    /// Its exit status, or 128 + n when signal n ended it; nothing while it runs. @throws FileError
    [[nodiscard]] std::optional<int> ended() { return wait(false); }

    /// Wait until it ends. @return as ended()  @throws FileError
    [[nodiscard]] int wait() { return *wait(true); }

    /// Wait until it ends, and ask every 10 ms whether to go on. @return as ended()  @throws FileError
    [[nodiscard]] std::optional<int> wait_while(const std::function<bool()>& go_on);

    /// Send it a signal, unless it is known to have ended. @pre it is not kept
    void signal(int number) const;

    /// End it and all of its descendants at once. @pre it is kept  @throws FileError
    void stop();

  private:
    std::optional<int> wait(bool block);

    std::string name_;
    pid_t id_ = 0;
    std::optional<int> status_;
    std::unique_ptr<Pipe> lifeline_;  ///< of the keeper, which ends when it is closed or written to; null: none
};

/// Run a program and wait until it ends.
/// @return its exit status, or 128 + n when signal n ended it
/// @throws FileError, ProcessesError  as ChildProcess
[[nodiscard]] int run_process(const Process& process);

/// Become another program: it takes over the process with its standard streams, so that signals reach it and its exit
/// status becomes this process's. It starts with the signal handlers of a ChildProcess.
/// @param program      as returned by find_program
/// @param environment  added to the environment of this process
/// @throws FileError  it cannot be started
[[noreturn]] void become_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                                 const std::vector<std::pair<std::string, std::string>>& environment);

}  // namespace ljmd
