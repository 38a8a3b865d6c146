#include <fmt/format.h>

#include <memory>
#include <optional>

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
#include "io/files/file_system.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/execution/execution.hpp"
#include "run/output_guard.hpp"
#include "run/run.hpp"
#include "run/run_directory.hpp"
#include "study/replicas.hpp"

namespace ljmd {

namespace {

struct ReadDeck {
    Deck deck;
    CheckedRun run;
};

class RunCommand : public Command {
  public:
    RunCommand() : Command("run", Part::runs, "run a deck and write its results") {}

    void add_options(CLI::App& command) override {
        options_.add_to(command);
        command.add_option("--out", out_, "output directory, instead of the deck's")->type_name("DIR");
        CLI::Option* replicas =
            command
                .add_option(
                    "--replicas", replicas_,
                    "as many independent runs, each with a seed and a directory of its own, and their merged results")
                ->type_name("N")
                ->check(CLI::Range(Index{1}, max_replicas));
        add_jobs(command, jobs_, "replicas at a time; one for each processor by default")->needs(replicas);
        replicas->excludes(command.get_option("--threads"))->excludes(command.get_option("--simd"));
        add_walltime(command, walltime_)->excludes(replicas);
    }

    [[nodiscard]] bool shares_work() const override { return replicas_ == 0; }

    void run() override {
        if (replicas_ > 0) {
            run_replicas();
            return;
        }
        const std::shared_ptr<Ranks> ranks = shared_ranks();
        options_.simd = agreed_simd(ranks, options_.simd);
        if (ranks && !ranks->is_root()) {
            run_as_member(ranks);
            return;
        }
        RunControl control{.interruption = until_signal(wall_time(walltime_))};
        std::optional<ReadDeck> read;
        prepare_together(ranks, [&] {
            read = read_deck(ranks);
            check_directory(read->deck, options_.force);
        });
        Deck& deck = read->deck;
        CheckedRun& run = read->run;
        require_shareable(ranks, deck, run);
        Progress progress(run.atoms(), total_steps(deck.stages()), options_.quiet);
        AnySystem system = make_system(deck, std::move(run.start), run.execution,
                                       [&](const std::string& text) { progress.warning(text); });
        install_stop_handlers();  // before this, nothing would be lost
        show_run(deck, progress, options_.json,
                 [&] { return run_in_locked_directory(deck, system, options_.force, progress, control); });
    }

  private:
    ReadDeck read_deck(const std::shared_ptr<Ranks>& ranks) const {
        Diagnostics diagnostics;
        Deck deck = options_.load(diagnostics);
        if (!out_.empty()) {
            deck.directory = out_;
        }
        CheckedRun run = options_.checked(deck, diagnostics, ranks);
        return {std::move(deck), std::move(run)};
    }

    /// The part of a rank other than rank 0, whose options have no effect on files and screen.
    void run_as_member(const std::shared_ptr<Ranks>& ranks) {
        options_.quiet = true;
        ignore_stop_signals();
        std::optional<ReadDeck> read;
        prepare_together(ranks, [&] { read = read_deck(ranks); });
        require_shareable(ranks, read->deck, read->run);
        RunListener silent;
        AnySystem system = make_system(read->deck, std::move(read->run.start), read->run.execution, [](const auto&) {});
        run_plan(read->deck, system, silent);
    }

    void run_replicas() const {
        install_stop_handlers();
        Diagnostics diagnostics;
        Deck deck = options_.load(diagnostics);
        require_fluid(deck, "replicas are runs with other random numbers, and a motion of few bodies has none");
        const CheckedRun run = checked_run(deck, 1, options_.simd, diagnostics);
        if (!options_.quiet) {
            print_warnings(diagnostics);
        }
        if (const std::string why = why_all_the_same(deck, run.start.value()); !why.empty()) {
            throw InputError(why);
        }
        if (!out_.empty()) {
            deck.directory = out_;
        }
        const SweepPlan plan = replica_plan(deck, options_.all_settings(), replicas_);
        make_directory(deck.directory);
        const DirectoryLock lock(deck.directory);
        require_no_run(deck.directory, "Nothing was run");
        prepare_sweep(plan, lock.directory(), options_.force, wait_for_writing_runs);
        print_document(complete_replicas(plan, lock.directory(), deck, jobs_, options_.quiet), options_.json);
    }

    DeckOptions options_;
    std::string out_;
    std::string walltime_;
    Index replicas_ = 0;  ///< 0: one run
    int jobs_ = 0;
};

}  // namespace

std::shared_ptr<Command> run_command() {
    return std::make_shared<RunCommand>();
}

}  // namespace ljmd
