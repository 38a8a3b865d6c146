#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/core/types.hpp"
#include "ljmd/execution/threads.hpp"
#include "ljmd/study/job_pool.hpp"

namespace ljmd {

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

/// Whether the directory holds a run of another deck or with other settings.
/// @throws DataError  its run.json is damaged
[[nodiscard]] bool holds_another_run(const ChildRun& run);

/// The job that completes the run: `ljmd resume` if this run has left a checkpoint, else `ljmd run`; nothing if it is
/// finished. Another run in the directory is replaced. @throws DataError  its run.json is damaged
[[nodiscard]] std::optional<Job> next_job(const ChildRun& run);

/// The job that extends a finished run.
[[nodiscard]] Job longer(const ChildRun& run, Index more_steps);

/// "NAME: exit code 5: error: the run has blown up": the last error in its log, or its last line.
[[nodiscard]] std::string failure_of(const ChildRun& run, int exit_status);

/// The last line with an error in a log; empty if there is none, or no log.
[[nodiscard]] std::string error_in_log(const std::filesystem::path& log);

/// Run lines of jobs of this program, several lines at a time.
///
/// @tparam Line  has begin(), which returns the first job or nothing, and after(exit_status), which returns the next
/// job, or nothing at the end of the line
/// @param jobs   lines at a time; 0: the number of processors
/// @param ended  called as ended(line, done) at the end of each line, when `done` lines have ended
/// @throws Interrupted, FileError  as run_jobs()
template <class Line, class Ended>
void run_lines(std::vector<Line>& lines, int jobs, const Interruption& interruption, const Ended& ended) {
    std::vector<Job> first;
    std::vector<Line*> with_jobs;
    std::size_t done = 0;
    for (Line& line : lines) {
        if (const auto job = line.begin()) {
            first.push_back(*job);
            with_jobs.push_back(&line);
        } else {
            ended(line, ++done);
        }
    }
    const auto next = [&](std::size_t k, int exit_status) {
        auto job = with_jobs[k]->after(exit_status);
        if (!job) {
            ended(*with_jobs[k], ++done);
        }
        return job;
    };
    run_jobs(this_program(), first, jobs > 0 ? jobs : available_processors(), next, interruption);
}

}  // namespace ljmd
