#include "study/run_lines.hpp"

#include <fmt/format.h>

#include <chrono>
#include <set>
#include <thread>
#include <utility>

#include "execution/threads.hpp"
#include "io/files/claimed_file.hpp"
#include "io/files/directory_lock.hpp"
#include "io/files/program_module.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

/// The log of a run that is now ours; nothing if another process writes to the log or to the directory.
std::optional<ClaimedFile> claimed_log(const ChildRun& run) {
    return DirectoryLock::is_held(run.directory) ? std::nullopt : ClaimedFile::claim(run.log);
}

/// One pass over the lines that are left.
class Pass {
  public:
    using Ended = std::function<void(RunLine&)>;

    Pass(std::vector<RunLine*> lines, const Ended& ended)
        : lines_(std::move(lines)), logs_(lines_.size()), ended_(ended) {}

    /// @return lines that other processes hold  @throws Interrupted
    std::vector<RunLine*> run(int jobs, const Interruption& interruption) {
        run_jobs(
            this_program(), lines_.size(), jobs, [this](std::size_t k) { return first(k); },
            [this](std::size_t k, int status) { return next(k, status); }, interruption);
        return std::move(held_);
    }

  private:
    std::optional<Job> first(std::size_t k) {
        logs_[k] = claimed_log(lines_[k]->run());
        if (!logs_[k]) {
            held_.push_back(lines_[k]);
            return std::nullopt;
        }
        return begun(k, lines_[k]->begin());
    }

    std::optional<Job> next(std::size_t k, int status) {
        if (status == exit_status_in_use) {  // somebody has resumed the run by hand
            logs_[k]->clear();
            logs_[k].reset();
            held_.push_back(lines_[k]);
            return std::nullopt;
        }
        record_end(*logs_[k], status);
        return begun(k, lines_[k]->after(status));
    }

    std::optional<Job> begun(std::size_t k, std::optional<Job> job) {
        if (job) {
            logs_[k]->clear();
            job->output_descriptor = logs_[k]->descriptor();
        } else {
            logs_[k].reset();
            ended_(*lines_[k]);
        }
        return job;
    }

    std::vector<RunLine*> lines_;
    std::vector<std::optional<ClaimedFile>> logs_;
    std::vector<RunLine*> held_;
    const Ended& ended_;
};

/// @return nothing if it throws: then the line has failed
template <class Find>
std::optional<Job> job_or_failure(RunLine& line, const Find& find) {
    try {
        return find();
    } catch (const Error& error) {
        line.set_failure(fmt::format("{}: {}", line.run().name, error.what()));
        return std::nullopt;
    }
}

}  // namespace

std::optional<Job> RunLine::begin() {
    return job_or_failure(*this, [this] { return first_job(); });
}

std::optional<Job> RunLine::after(int exit_status) {
    if (exit_status != 0) {
        failure_ = failure_of(run(), exit_status);
        return std::nullopt;
    }
    return job_or_failure(*this, [this] { return next_job(); });
}

void run_lines(const std::vector<RunLine*>& lines, int jobs, const Interruption& interruption,
               const std::function<void(RunLine& line, std::size_t done)>& ended,
               const std::function<void(const std::string&)>& tell) {
    constexpr std::chrono::milliseconds moment{50};
    std::size_t done = 0;
    const Pass::Ended count_ended = [&](RunLine& line) { ended(line, ++done); };
    std::set<const RunLine*> told;
    std::vector<RunLine*> left = lines;
    while (!left.empty()) {
        left = Pass(std::move(left), count_ended).run(jobs > 0 ? jobs : available_processors(), interruption);
        for (const RunLine* line : left) {
            if (told.insert(line).second) {
                tell(fmt::format("waiting for the run that is still writing to {}\n", line->run().directory.string()));
            }
        }
        if (!left.empty()) {
            std::this_thread::sleep_for(moment);
            if (interruption.wanted()) {
                interruption.stop_many_runs();
            }
        }
    }
}

}  // namespace ljmd
