#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "io/files/claimed_file.hpp"
#include "ljmd/core/types.hpp"
#include "study/job_pool.hpp"

namespace ljmd {

/// Exit status of a run whose directory another process holds.
inline constexpr int exit_status_in_use = 9;

/// A run that is completed by child processes of this program, one thread each. A command that needs many runs has many
/// of these.
struct ChildRun {
    std::string name;                     ///< its name in messages
    std::filesystem::path deck;           ///< deck file, for `ljmd run`
    std::string source;                   ///< text of the deck
    std::vector<std::string> settings{};  ///< arguments of --set
    std::filesystem::path directory;
    std::filesystem::path log;  ///< file for the messages of the process
};

/// Refuse places through which something else would be written: a log that is not a regular file, a directory that is a
/// link, or a parent folder that is a link. @throws InputError
void check_places(const ChildRun& run);

/// Wait until no process holds a lock on a directory in `folder`. After the command that started them was killed, runs
/// may still be writing their last checkpoints.
/// @param tell  receives one line for each run that is waited for
/// @throws Interrupted by a signal
void wait_for_runs(const std::filesystem::path& folder, const Interruption& interruption,
                   const std::function<void(const std::string&)>& tell);

/// Whether the directory holds a run of another deck or with other settings. One whose run.json cannot be read is not
/// known to be another: when its turn comes it fails by itself.
[[nodiscard]] bool holds_another_run(const ChildRun& run);

/// The job that completes the run: `ljmd resume` if this run has left a checkpoint, else `ljmd run`; nothing if it is
/// finished. No other run is replaced.
/// @throws DataError  the directory holds another run, its run.json is damaged, or the run would begin and its deck
/// file is not the deck
[[nodiscard]] std::optional<Job> next_job(const ChildRun& run);

/// Take a directory that holds another run, or one whose run.json is damaged, as empty: next_job() begins the run anew.
/// Nothing is done while a process writes to it. @throws FileError
void forget_another_run(const ChildRun& run);

/// The job that extends a finished run.
[[nodiscard]] Job longer(const ChildRun& run, Index more_steps);

/// "NAME: exit code 5: error: the run has blown up": the last error in its log, or its last line.
[[nodiscard]] std::string failure_of(const ChildRun& run, int exit_status);

/// Note in the log of a run that it has failed; nothing if it has come to its end, or was stopped with a checkpoint. If
/// the log cannot be written, nothing is noted.
void record_end(const ClaimedFile& log, int exit_status);

/// Why the last attempt at a run has failed, from its log: "exit code 5: error: the run has blown up", or only the last
/// line with an error; empty if it has not failed, or there is no log.
[[nodiscard]] std::string recorded_failure(const std::filesystem::path& log);

}  // namespace ljmd
