#pragma once

#include <string>
#include <vector>

#include "io/files/open_directory.hpp"

namespace ljmd {

/// Files of an earlier run that a new run in the same directory will replace. They are kept in a folder `.ljmd-earlier`
/// there until the new run has its first checkpoint. If it fails before that, they are put back. A program that is
/// killed in between leaves them there, see settle_earlier_run().
class EarlierRun {
  public:
    /// Move the files with these names into the folder.
    /// @pre the directory is held alone, and there is no such folder (settle_earlier_run)
    /// @throws FileError; nothing has changed then
    EarlierRun(OpenDirectory directory, std::vector<std::string> names);
    /// Puts the files back unless they were discarded.
    ~EarlierRun();
    EarlierRun(const EarlierRun&) = delete;
    EarlierRun& operator=(const EarlierRun&) = delete;

    /// Remove the earlier run: the new one can now be resumed. Files that cannot be removed stay in a folder
    /// `.ljmd-replaced`, for remove_replaced_run().
    void discard();

  private:
    OpenDirectory directory_;
    std::vector<std::string> names_;
    bool aside_ = false;
};

/// Remove what is left of an earlier run that was discarded. Files that cannot be removed stay.
/// @pre the directory is locked  @throws FileError
void remove_replaced_run(const OpenDirectory& directory, const std::vector<std::string>& names);

/// Clean up after a program that was killed while it replaced a run: remove the earlier run if it was discarded or the
/// new one has a checkpoint, else put it back in place of the new run's files.
/// @pre the directory is locked  @return whether it was put back  @throws FileError
bool settle_earlier_run(const OpenDirectory& directory, const std::vector<std::string>& names);

}  // namespace ljmd
