#pragma once

#include <string>
#include <vector>

#include "ljmd/io/files/open_directory.hpp"

namespace ljmd {

/// Files of an earlier run that a new one in the same directory is to replace. They are set aside, in a folder
/// `.ljmd-earlier` there, until the new run has its first checkpoint; when it fails before that, they are put back.
/// A program that is killed meanwhile leaves them aside, see settle_earlier_run().
class EarlierRun {
  public:
    /// Move the files with these names aside.
    /// @pre the directory is held alone, and there is no such folder (settle_earlier_run)
    /// @throws FileError; then all is as it was
    EarlierRun(OpenDirectory directory, std::vector<std::string> names);
    /// Puts back what was not discarded.
    ~EarlierRun();
    EarlierRun(const EarlierRun&) = delete;
    EarlierRun& operator=(const EarlierRun&) = delete;

    /// Remove the earlier run: the new one can be resumed now.
    void discard();

  private:
    OpenDirectory directory_;
    std::vector<std::string> names_;
    bool aside_ = false;
};

/// Where a program was killed that had set an earlier run aside: remove that when the new run has a checkpoint, else
/// put it back in place of what the new run has written.
/// @pre the directory is locked  @return whether it was put back  @throws FileError
bool settle_earlier_run(const OpenDirectory& directory, const std::vector<std::string>& names);

}  // namespace ljmd
