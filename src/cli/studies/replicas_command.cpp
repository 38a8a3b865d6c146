#include "ljmd/cli/studies/replicas_command.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "ljmd/cli/signals.hpp"
#include "ljmd/cli/streams.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/deck/checked_run.hpp"
#include "ljmd/deck/deck.hpp"
#include "ljmd/io/files/directory_lock.hpp"
#include "ljmd/io/files/file_system.hpp"
#include "ljmd/run/output_guard.hpp"
#include "ljmd/run/recorded_run.hpp"
#include "ljmd/run/run_directory.hpp"
#include "ljmd/study/child_run.hpp"
#include "ljmd/study/replicas.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

/// A replica being computed, by one run and by what steps that were added later need.
class ReplicaRun {
  public:
    ReplicaRun(ChildRun run, Index steps_added) : run_(std::move(run)), steps_added_(steps_added) {}

    [[nodiscard]] const ChildRun& run() const { return run_; }
    [[nodiscard]] const std::string& failure() const { return failure_; }

    std::optional<Job> begin() {
        auto job = next_job(run_);
        return job ? job : lengthening();
    }

    std::optional<Job> after(int exit_status) {
        if (exit_status != 0) {
            failure_ = failure_of(run_, exit_status);
            return std::nullopt;
        }
        return lengthening();
    }

  private:
    /// The job that adds the steps that this run does not have yet.
    [[nodiscard]] std::optional<Job> lengthening() const {
        const Index missing = steps_added_ - recorded_run(run_.directory).earlier.steps_added;
        return missing > 0 ? std::optional(longer(run_, missing)) : std::nullopt;
    }

    ChildRun run_;
    Index steps_added_;
    std::string failure_;
};

/// The deck of replicas with the settings of the command line.
Deck deck_of(const SweepPlan& plan) {
    Diagnostics diagnostics;
    auto deck = load_deck_text(plan.deck_file, plan.deck, plan.settings, true, diagnostics);
    diagnostics.throw_if_errors();
    return std::move(*deck);
}

/// Run all replicas to their ends and merge their results.
/// @throws PhysicsError  if any have failed
void complete(const SweepPlan& plan, const OpenDirectory& directory, const Deck& deck, int jobs, bool quiet,
              bool json) {
    std::vector<ReplicaRun> runs;
    for (ChildRun& run : sweep_runs(plan, directory.path())) {
        runs.emplace_back(std::move(run), plan.steps_added);
    }
    std::string failures;
    std::size_t failed = 0;
    run_lines(runs, jobs, until_signal(), [&](const ReplicaRun& run, std::size_t done) {
        directory.require_at_its_path();  // runs are started by path
        if (!run.failure().empty()) {
            warn(run.failure());
            failures += "\n  " + run.failure();
            ++failed;
        } else if (!quiet) {
            print_message(fmt::format("[{}/{}] {}: finished\n", done, runs.size(), run.run().name));
        }
    });
    directory.require_at_its_path();
    if (failed > 0) {
        throw PhysicsError(fmt::format("{} of {} replicas failed; to try them again: ljmd resume {}{}", failed,
                                       runs.size(), directory.path().string(), failures));
    }
    std::vector<ChildRun> children;
    children.reserve(runs.size());
    for (const ReplicaRun& run : runs) {
        children.push_back(run.run());
    }
    const Document report = replicas_report(deck, children, directory.path());
    write_replicas(report, children, directory);
    print_document(report, json);
}

}  // namespace

void replicas_command(const DeckOptions& options, const std::string& out, Index replicas, int jobs) {
    install_stop_handlers();
    std::vector<std::string> settings = options.settings;
    if (!options.precision.empty()) {
        settings.push_back("performance.precision=" + options.precision);
    }
    Diagnostics diagnostics;
    auto deck = load_deck(options.deck, settings, options.force, diagnostics);
    diagnostics.throw_if_errors();
    require_fluid(*deck, "replicas are runs with other random numbers, and a motion of few bodies has none");
    const CheckedRun run = checked_run(*deck, 1, options.simd, diagnostics);
    if (!options.quiet) {
        print_warnings(diagnostics);
    }
    if (const std::string why = why_all_the_same(*deck, run.start.value()); !why.empty()) {
        throw InputError(why);
    }
    if (!out.empty()) {
        deck->directory = out;
    }
    const SweepPlan plan = replica_plan(*deck, settings, replicas);
    make_directory(deck->directory);
    const DirectoryLock lock(deck->directory);
    require_no_run(deck->directory, "Nothing was run");
    wait_for_runs(deck->directory / "points", until_signal(), print_message);
    prepare_sweep(plan, lock.directory(), options.force);
    complete(plan, lock.directory(), *deck, jobs, options.quiet, options.json);
}

bool holds_replicas(const std::string& directory) {
    if (!files::exists(fs::path(directory) / "sweep.json")) {
        return false;
    }
    const auto plan = recorded_sweep(directory);
    return plan && plan->replicas > 0;
}

void resume_replicas(const ResumeOptions& options, int jobs) {
    install_stop_handlers();
    const fs::path directory = options.directory;
    const DirectoryLock lock(directory);
    wait_for_runs(directory / "points", until_signal(), print_message);
    SweepPlan plan = recorded_sweep(directory).value();
    const Deck deck = deck_of(plan);
    if (options.more_steps > 0) {
        plan.steps_added += options.more_steps;
        record_sweep(plan, lock.directory());
    }
    complete(plan, lock.directory(), deck, jobs, options.quiet, options.json);
}

}  // namespace ljmd
