#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <variant>

#include "cli/command.hpp"
#include "cli/deck_options.hpp"
#include "cli/progress.hpp"
#include "cli/ranks.hpp"
#include "cli/shown_run.hpp"
#include "cli/signals.hpp"
#include "cli/streams.hpp"
#include "cli/studies/replica_study.hpp"
#include "cli/studies/study_steps.hpp"
#include "deck/deck_system.hpp"
#include "io/files/directory_lock.hpp"
#include "io/files/shell_word.hpp"
#include "run/held_run.hpp"
#include "run/run.hpp"

namespace ljmd {

namespace {

class ResumeCommand : public Command {
  public:
    ResumeCommand() : Command("resume", Part::runs, "resume a run that was stopped, from its last checkpoint") {}

    void add_options(CLI::App& command) override {
        command.add_option("directory", directory_, "directory of the run")->required()->type_name("RUNDIR");
        command.add_option("--steps", more_steps_, "add steps to the last stage: +N")
            ->type_name("+N")
            ->check(CLI::Range(Index{1}, max_steps));
        add_walltime(command, walltime_);
        add_threads(command, threads_, "threads to share the work; as many as before by default");
        add_jobs(command, jobs_, "of replicas: at a time; one for each processor by default");
        command.add_flag("--quiet", quiet_, "no progress");
        command.add_flag("--json", json_, "print the result as JSON");
    }

    [[nodiscard]] bool shares_work() const override { return !holds_replicas(directory_); }

    void run() override {
        if (holds_replicas(directory_)) {
            resume_replicas();
            return;
        }
        const std::shared_ptr<Ranks> ranks = shared_ranks();
        if (ranks && !ranks->is_root()) {
            resume_as_member(ranks);
            return;
        }
        RunControl control{.interruption = until_signal(wall_time(walltime_))};
        install_stop_handlers();
        std::optional<HeldRun> held;
        prepare_together(ranks, [&] { held.emplace(directory_, more_steps_, threads_, warn, GivenAgain{}, ranks); });
        prepare_together(ranks, [] {});  // the others have read the checkpoint
        HeldRun& run = *held;
        require_shareable(ranks, run);
        const CheckpointHead from = run.checkpoint();
        AnySystem system = empty_system(run.deck(), from.atoms, from.edges, run.execution());
        Progress progress(std::holds_alternative<FluidSystem>(system) ? std::optional(from.atoms) : std::nullopt,
                          total_steps(run.deck().stages()), quiet_, from.step);
        tell_beginning(run, progress);
        control.continuation = run.take();
        show_run(run.deck(), progress, json_, [&] { return run_plan(run.deck(), system, progress, control); });
        run.warn_if_moved();
    }

  private:
    void tell_beginning(const HeldRun& run, Progress& progress) const {
        for (const std::string& warning : run.warnings()) {
            progress.warning(warning);
        }
        if (quiet_) {
            return;
        }
        const Index step = run.checkpoint().step;
        print_message(
            run.is_at_its_end()
                ? fmt::format("the run was finished after step {}, its results are written anew; to make it longer: "
                              "ljmd resume {} --steps +N\n",
                              step, shell_word(directory_))
                : fmt::format("resuming after step {} of {}{}\n", step,
                              run.deck().stages().back().until.empty() ? "" : "at most ",
                              total_steps(run.deck().stages())));
    }

    void resume_as_member(const std::shared_ptr<Ranks>& ranks) const {
        ignore_stop_signals();
        std::optional<HeldRun> run;
        prepare_together(ranks, [] {});  // rank 0 holds the directory
        prepare_together(ranks, [&] {
            run.emplace(
                directory_, more_steps_, threads_, [](const std::string&) {}, GivenAgain{}, ranks);
        });
        require_shareable(ranks, *run);
        const CheckpointHead from = run->checkpoint();
        AnySystem system = empty_system(run->deck(), from.atoms, from.edges, run->execution());
        RunListener silent;
        run_plan(run->deck(), system, silent, {.continuation = run->take()});
    }

    /// Resume all replicas, add steps to all of them, and merge their results anew.
    void resume_replicas() const {
        install_stop_handlers();
        const std::filesystem::path directory = directory_;
        const DirectoryLock lock(directory);
        wait_for_writing_runs(directory / "points");
        SweepPlan plan = recorded_sweep(directory).value();
        const Deck deck = deck_of_replicas(plan);
        if (more_steps_ > 0) {
            plan.steps_added += more_steps_;
            record_sweep(plan, lock.directory());
        }
        print_document(complete_replicas(plan, lock.directory(), deck, jobs_, quiet_), json_);
    }

    std::string directory_;
    std::string walltime_;
    Index more_steps_ = 0;  ///< added to the last stage
    int threads_ = 0;       ///< 0: as many as before
    int jobs_ = 0;          ///< replicas at a time; 0: the number of processors
    bool quiet_ = false;
    bool json_ = false;
};

}  // namespace

std::shared_ptr<Command> resume_command() {
    return std::make_shared<ResumeCommand>();
}

}  // namespace ljmd
