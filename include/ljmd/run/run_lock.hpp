#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "ljmd/deck/deck.hpp"
#include "ljmd/io/files/directory_lock.hpp"
#include "ljmd/run/earlier_run.hpp"

namespace ljmd {

/// Holds the directory of a run while a command writes there. First it puts right what a killed program left in the
/// middle of replacing a run (settle_earlier_run).
class RunLock {
  public:
    using Warn = std::function<void(const std::string&)>;  ///< receives one line for each thing a user should know

    /// For a run that is resumed. @throws FileError, InUseError
    RunLock(const std::filesystem::path& directory, Warn warn);

    /// For a new run, which then writes to the directory that is locked (Deck::locked). The directory is made if it is
    /// not there; with `force` an earlier run in it is set aside until has_begun().
    /// @throws InputError  as check_directory()  @throws FileError, InUseError; then all is as it was
    RunLock(Deck& deck, bool force, Warn warn);

    [[nodiscard]] const OpenDirectory& directory() const { return lock_.directory(); }

    /// The new run can be gone on with: the earlier one is removed.
    void has_begun();

    /// Tell the user at the end when the files are not where they were asked for, as the directory was moved.
    void warn_if_moved() const;

  private:
    DirectoryLock lock_;
    Warn warn_;
    std::optional<EarlierRun> earlier_;
};

}  // namespace ljmd
