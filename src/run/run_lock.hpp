#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "deck/deck.hpp"
#include "io/files/directory_lock.hpp"
#include "ljmd/core/errors.hpp"
#include "run/earlier_run.hpp"

namespace ljmd {

/// Holds the directory of a run locked while a command writes there. First it cleans up after a program that was killed
/// while it replaced a run (settle_earlier_run); at the end it removes what could not be removed of a replaced run
/// before.
class RunLock {
  public:
    using Warn = std::function<void(const std::string&)>;  ///< receives one line per remark for the user

    /// For a resumed run. @throws FileError, InUseError
    RunLock(const std::filesystem::path& directory, Warn warn);

    /// For a new run, which then writes to the locked directory (Deck::locked). The directory is created if it is
    /// missing. With `force` an earlier run in it is set aside until has_begun().
    /// @throws InputError  as check_directory()  @throws FileError, InUseError; nothing has changed then
    RunLock(RunPlan& plan, bool force, Warn warn);

    ~RunLock();
    RunLock(const RunLock&) = delete;
    RunLock& operator=(const RunLock&) = delete;

    [[nodiscard]] const OpenDirectory& directory() const { return lock_.directory(); }

    /// The new run can be resumed: remove the earlier one.
    void has_begun();

    /// Call `work`, which runs in the directory.
    /// @throws FileError  and says that the run cannot be resumed, if it fails before has_begun()
    template <class Work>
    auto run(const Work& work) {
        try {
            return work();
        } catch (const FileError& error) {
            if (begun_) {
                throw;
            }
            throw FileError(std::string(error.what()) +
                            "\n  it cannot be resumed, because it has no checkpoint yet: begin it again");
        }
    }

    /// Warn at the end if the directory was moved, so that the files are not where the user expects them.
    void warn_if_moved() const;

  private:
    DirectoryLock lock_;
    Warn warn_;
    std::optional<EarlierRun> earlier_;
    bool begun_ = false;
};

}  // namespace ljmd
