#include "cli/studies/replica_study.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>
#include <vector>

#include "cli/signals.hpp"
#include "cli/streams.hpp"
#include "io/files/file_system.hpp"
#include "io/files/shell_word.hpp"
#include "ljmd/core/errors.hpp"
#include "run/recorded_run.hpp"
#include "study/child_run.hpp"
#include "study/replicas.hpp"
#include "study/run_lines.hpp"

namespace ljmd {

namespace {

/// A replica being computed, by one run and by what steps that were added later need.
class ReplicaRun : public RunLine {
  public:
    ReplicaRun(ChildRun run, Index steps_added) : run_(std::move(run)), steps_added_(steps_added) {}

    [[nodiscard]] const ChildRun& run() const override { return run_; }

  private:
    std::optional<Job> first_job() override {
        auto job = ljmd::next_job(run_);
        return job ? job : next_job();
    }

    /// The job that adds the steps that this run does not have yet.
    std::optional<Job> next_job() override {
        const Index missing = steps_added_ - recorded_run(run_.directory).earlier.steps_added;
        return missing > 0 ? std::optional(longer(run_, missing)) : std::nullopt;
    }

    ChildRun run_;
    Index steps_added_;
};

}  // namespace

bool holds_replicas(const std::filesystem::path& directory) {
    if (!files::exists(directory / "sweep.json")) {
        return false;
    }
    const auto plan = recorded_sweep(directory);
    return plan && plan->replicas > 0;
}

Deck deck_of_replicas(const SweepPlan& plan) {
    Diagnostics diagnostics;
    auto deck = load_deck_text(plan.deck_file, plan.deck, plan.settings, true, diagnostics);
    diagnostics.throw_if_errors();
    return std::move(*deck);
}

Document complete_replicas(const SweepPlan& plan, const OpenDirectory& directory, const Deck& deck, int jobs,
                           bool quiet) {
    std::vector<ReplicaRun> runs;
    for (ChildRun& run : sweep_runs(plan, directory.path())) {
        runs.emplace_back(std::move(run), plan.steps_added);
    }
    std::string failures;
    std::size_t failed = 0;
    run_lines(
        pointers_to(runs), jobs, until_signal(),
        [&](const RunLine& run, std::size_t done) {
            directory.require_at_its_path();  // runs are started by path
            if (!run.failure().empty()) {
                warn(run.failure());
                failures += "\n  " + run.failure();
                ++failed;
            } else if (!quiet) {
                print_message(fmt::format("[{}/{}] {}: finished\n", done, runs.size(), run.run().name));
            }
        },
        print_message);
    directory.require_at_its_path();
    if (failed > 0) {
        throw PhysicsError(fmt::format("{} of {} replicas failed; to try them again: ljmd resume {}{}", failed,
                                       runs.size(), shell_word(directory.path()), failures));
    }
    std::vector<ChildRun> children;
    children.reserve(runs.size());
    for (const ReplicaRun& run : runs) {
        children.push_back(run.run());
    }
    Document report = replicas_report(deck, children, directory.path());
    write_replicas(report, children, directory);
    return report;
}

}  // namespace ljmd
