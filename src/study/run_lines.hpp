#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "study/child_run.hpp"

namespace ljmd {

/// A run of a study on its way to its end: jobs that follow one another. One whose record cannot be read fails by
/// itself: the other runs of the study go on.
class RunLine {
  public:
    RunLine() = default;
    RunLine(const RunLine&) = default;
    RunLine(RunLine&&) = default;
    RunLine& operator=(const RunLine&) = delete;
    RunLine& operator=(RunLine&&) = delete;
    virtual ~RunLine() = default;

    [[nodiscard]] virtual const ChildRun& run() const = 0;

    /// The first job, from what is in the directory of the run; nothing if the run is at its end or has failed.
    [[nodiscard]] std::optional<Job> begin();

    /// The next job after one has ended; nothing if the run is at its end or has failed.
    [[nodiscard]] std::optional<Job> after(int exit_status);

    /// Why it has failed, "NAME: exit code 5: error: ..."; empty if it has not.
    [[nodiscard]] const std::string& failure() const { return failure_; }

    /// Take it as failed, because another process has tried it. @param why  as failure()
    void set_failure(std::string why) { failure_ = std::move(why); }

  private:
    /// As begin(). @throws Error  what is in the directory cannot be used
    [[nodiscard]] virtual std::optional<Job> first_job() = 0;

    /// As after(), for a job that has ended well. @throws Error  what it has left cannot be used
    [[nodiscard]] virtual std::optional<Job> next_job() = 0;

    std::string failure_;
};

/// Pointers to lines of one type.
template <class Line>
[[nodiscard]] std::vector<RunLine*> pointers_to(std::vector<Line>& lines) {
    std::vector<RunLine*> pointers;
    pointers.reserve(lines.size());
    for (Line& line : lines) {
        pointers.push_back(&line);
    }
    return pointers;
}

/// Bring runs to their ends, several at a time, by jobs of this program.
///
/// Any number of processes may work on the same runs. A run is claimed by its log (ClaimedFile) before it is known what
/// is left to do, and held until it is at its end. Runs that another process holds are left to it: when all others are
/// at their ends they are waited for, and completed if that process has left them unfinished.
/// @param jobs   runs at a time; 0: the number of processors
/// @param ended  called as ended(line, done) when a line is at its end or has failed, as the done-th
/// @param tell   receives one line for each run that is waited for
/// @throws Interrupted, FileError  as run_jobs()
void run_lines(const std::vector<RunLine*>& lines, int jobs, const Interruption& interruption,
               const std::function<void(RunLine& line, std::size_t done)>& ended,
               const std::function<void(const std::string&)>& tell);

}  // namespace ljmd
