#include "ljmd/cli/studies/replicas_command.hpp"

#include <filesystem>
#include <string>
#include <vector>

#include "ljmd/cli/signals.hpp"
#include "ljmd/cli/streams.hpp"
#include "ljmd/cli/studies/replica_study.hpp"
#include "ljmd/cli/studies/study_steps.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/deck/checked_run.hpp"
#include "ljmd/deck/deck.hpp"
#include "ljmd/io/files/directory_lock.hpp"
#include "ljmd/io/files/file_system.hpp"
#include "ljmd/run/output_guard.hpp"
#include "ljmd/run/run_directory.hpp"
#include "ljmd/study/child_run.hpp"
#include "ljmd/study/replicas.hpp"

namespace ljmd {

namespace fs = std::filesystem;

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
    prepare_sweep(plan, lock.directory(), options.force, wait_for_writing_runs);
    print_document(complete_replicas(plan, lock.directory(), *deck, jobs, options.quiet), options.json);
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
    wait_for_writing_runs(directory / "points");
    SweepPlan plan = recorded_sweep(directory).value();
    const Deck deck = deck_of_replicas(plan);
    if (options.more_steps > 0) {
        plan.steps_added += options.more_steps;
        record_sweep(plan, lock.directory());
    }
    print_document(complete_replicas(plan, lock.directory(), deck, jobs, options.quiet), options.json);
}

}  // namespace ljmd
