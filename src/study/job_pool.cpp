#include "study/job_pool.hpp"

#include <fmt/format.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "io/files/process.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

constexpr std::chrono::milliseconds look_again{10};

/// A line of jobs with its running job.
struct Running {
    std::size_t line;
    ChildProcess process;
};

class Pool {
  public:
    Pool(const std::filesystem::path& program, int at_most) : program_(program), at_most_(at_most) {}

    /// Stops all jobs and waits for them.
    ~Pool() {
        stop();
        while (!running_.empty()) {
            try {
                static_cast<void>(running_.back().process.wait());
            } catch (const Error&) {
            }
            running_.pop_back();
        }
    }
    Pool(const Pool&) = delete;
    Pool& operator=(const Pool&) = delete;

    /// If this program is killed, the jobs receive SIGTERM and stop with checkpoints.
    void start(std::size_t line, const Job& job) {
        try {
            running_.push_back({line, ChildProcess({.program = program_,
                                                    .arguments = job.arguments,
                                                    .directory = ".",
                                                    .output = job.output,
                                                    .own_group = true,
                                                    .at_our_end = SIGTERM,
                                                    .output_descriptor = job.output_descriptor})});
        } catch (const ProcessesError& refused) {
            if (at_most_ == 1) {
                throw;
            }
            throw ProcessesError(fmt::format("{}\n  {} ran at a time; --jobs asks for fewer than {}", refused.what(),
                                             running_.size(), at_most_));
        }
    }

    /// Ask all jobs to stop with checkpoints: by SIGUSR1. A queue sends SIGTERM to all processes of a task, and a
    /// second SIGTERM would end a job without a checkpoint.
    void stop() const {
        for (const Running& one : running_) {
            one.process.signal(SIGUSR1);
        }
    }

    [[nodiscard]] std::size_t size() const { return running_.size(); }

    /// Remove a job that has ended: its line and exit status; nothing if all are running.
    std::optional<std::pair<std::size_t, int>> take_ended() {
        for (auto one = running_.begin(); one != running_.end(); ++one) {
            if (const auto status = one->process.ended()) {
                const std::pair found(one->line, *status);
                running_.erase(one);
                return found;
            }
        }
        return std::nullopt;
    }

  private:
    std::filesystem::path program_;
    int at_most_;
    std::vector<Running> running_;
};

}  // namespace

void run_jobs(const std::filesystem::path& program, std::size_t lines, int at_most, const FirstJob& first,
              const NextJob& next, const Interruption& interruption) {
    Pool pool(program, at_most);
    std::size_t begun = 0;
    bool stopped = false;
    while (pool.size() > 0 || (begun < lines && !stopped)) {
        if (!stopped && interruption.wanted()) {
            stopped = true;
            pool.stop();
        }
        if (!stopped && begun < lines && pool.size() < static_cast<std::size_t>(at_most)) {
            if (const auto job = first(begun)) {
                pool.start(begun, *job);
            }
            ++begun;
        } else if (const auto ended = pool.take_ended()) {
            const auto& [line, status] = *ended;
            if (stopped) {
                continue;
            }
            if (const auto job = next(line, status)) {
                pool.start(line, *job);
            }
        } else {
            std::this_thread::sleep_for(look_again);
        }
    }
    if (stopped) {
        interruption.stop_many_runs();
    }
}

}  // namespace ljmd
