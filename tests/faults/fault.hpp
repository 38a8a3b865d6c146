#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <optional>
#include <string>

#include "disk.hpp"

namespace ljmd::faults {

/// What a program asks of the file system.
enum class Kind : std::size_t {
    open,    ///< a file or folder that is there
    create,  ///< open, too, what may come into being or lose its content by it
    read,
    seek,  ///< to a place in an open file
    write,
    sync,
    close,  ///< of a file that was open for writing
    truncate,
    rename,
    remove,
    mkdir,
    link,
    stat,
    list,    ///< the next name in a folder
    lookup,  ///< what a link, a path or the working directory is
    lock,
    spawn,  ///< another program, with its output in a file
};

constexpr std::array<const char*, 17> kind_names{"open",  "create",   "read",   "seek",   "write", "sync",
                                                 "close", "truncate", "rename", "remove", "mkdir", "link",
                                                 "stat",  "list",     "lookup", "lock",   "spawn"};

struct NamedError;

/// What happens to a call.
enum class Fate { goes_on, is_short, torn, fails };

/// The fault that LJMD_FAULT asks for, see fault_at_call.cpp. Programs that this one starts do not have it.
class Fault {
  public:
    Fault();
    ~Fault();
    Fault(const Fault&) = delete;
    Fault& operator=(const Fault&) = delete;

    /// What becomes of the next call; errno is set when it fails.
    Fate next(Kind kind);

    /// To be called when a file is synced, or closed that was open for writing: whether it turns out now that what was
    /// written has found no space. errno is set.
    bool is_too_late();

    /// To be called after a file or folder has been synced.
    void synced(int descriptor);

    /// No fault from here on: for the other side of a fork.
    void spare_this_process() { mode_ = Mode::nothing; }

    /// What is to be added to the clock on the wall, in seconds.
    long clock_jump();

  private:
    enum class Mode { nothing, kill, tear, full, late, cut, clock, count, error, cut_short };

    Fate next_change(Kind kind);

    Mode mode_ = Mode::nothing;
    long at_ = 0;
    std::string file_;  ///< for the counts
    const NamedError* error_ = nullptr;
    Disk::Rest left_ = Disk::Rest::names;
    std::optional<Disk> disk_;  ///< where the power is cut
    std::atomic<long> calls_ = 0;
    std::atomic<long> times_ = 0;
    std::array<std::atomic<long>, kind_names.size()> calls_of_kind_{};
};

/// The one of this process. Nothing, while the fault itself looks at files.
Fault* fault();

}  // namespace ljmd::faults
