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

/// A run that processes of this program bring to its end, one thread each; a command that needs many runs has many.
struct ChildRun {
    std::string name;                     ///< what messages call it
    std::filesystem::path deck;           ///< file that `ljmd run` is given
    std::string source;                   ///< the text of it
    std::vector<std::string> settings{};  ///< of --set
    std::filesystem::path directory;
    std::filesystem::path log;  ///< file for what the process says
};

/// Refuse what leads elsewhere and would be written through: a log that is a link or a pipe, a directory, or the folder
/// that both are in, that is a link. @throws InputError
void check_places(const ChildRun& run);

/// Wait until no process has a lock on a directory in `folder`: when the command that started them was killed, runs
/// still write their last checkpoints for a moment. @throws Interrupted by a signal
/// @param tell  receives one line for each run that is waited for
void wait_for_runs(const std::filesystem::path& folder, const Interruption& interruption,
                   const std::function<void(const std::string&)>& tell);

/// Whether the directory holds a run of another deck, or with other settings.
/// @throws DataError  its run.json is damaged
[[nodiscard]] bool holds_another_run(const ChildRun& run);

/// What leads to the end: `ljmd run`, or `ljmd resume` where a part of this run has left a checkpoint; nothing when it
/// is finished. Another run in the directory is replaced. @throws DataError  its run.json is damaged
[[nodiscard]] std::optional<Job> next_job(const ChildRun& run);

/// Make a finished run longer.
[[nodiscard]] Job longer(const ChildRun& run, Index more_steps);

/// "NAME: exit code 5: error: the run has blown up": the last error in its log, or its last line.
[[nodiscard]] std::string failure_of(const ChildRun& run, int exit_status);

/// The last line in a log that tells of an error; empty without one, and without a log.
[[nodiscard]] std::string error_in_log(const std::filesystem::path& log);

/// Run lines of jobs of this program to their ends, several lines at a time.
///
/// @tparam Line  has begin(), the first job or nothing when there is nothing to do, and after(exit_status), the next
///               one or nothing at the end
/// @param jobs   lines at a time; 0: as many as there are processors
/// @param ended  is called as ended(line, done) for each line at its end, when `done` of them are there
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
