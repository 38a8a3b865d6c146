#include "run/held_run.hpp"

#include <fmt/format.h>

#include <utility>

#include "deck/deck_execution.hpp"
#include "execution/ranks.hpp"
#include "io/files/input_file.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

/// @return nothing where there is no directory: recorded_run() has the message for that
std::unique_ptr<RunLock> lock_of(const std::filesystem::path& directory, const RunLock::Warn& warn,
                                 const std::shared_ptr<Ranks>& ranks) {
    const bool has_files = !ranks || ranks->is_root();
    return has_files && input_is_directory(directory) ? std::make_unique<RunLock>(directory, warn) : nullptr;
}

ExecutionOptions options_of(const RecordedRun& run, int threads, const std::shared_ptr<Ranks>& ranks) {
    const std::string level =
        run.simd.empty() ? "" : std::string(name(level_with_digits_of(run.simd, run.deck.precision)));
    ExecutionOptions options = execution_options(run.deck, threads > 0 ? threads : run.threads, level);
    options.ranks = ranks;
    return options;
}

RecordedRun locked_run(const std::filesystem::path& directory, Index more_steps, const GivenAgain& again,
                       const std::unique_ptr<RunLock>& lock) {
    RecordedRun run = recorded_run(directory, more_steps);
    if (lock) {
        run.deck.locked = lock->directory();
    }
    run.deck.given = resumed_parts(std::move(run.deck.given), again, directory);
    return run;
}

Continuation newest_continuation(const RecordedRun& run) {
    auto continuation = find_continuation(run.deck, run.earlier);
    if (!continuation) {
        throw CheckpointError(fmt::format(
            "{} has no checkpoint: the run ended before its first one, or they were removed; begin it again",
            run.deck.directory.string()));
    }
    return std::move(*continuation);
}

}  // namespace

HeldRun::HeldRun(const std::filesystem::path& directory, Index more_steps, int threads, const RunLock::Warn& warn,
                 const GivenAgain& again, const std::shared_ptr<Ranks>& ranks)
    : lock_(lock_of(directory, warn, ranks)),
      run_(locked_run(directory, more_steps, again, lock_)),
      continuation_(newest_continuation(run_)),
      execution_(options_of(run_, threads, ranks)) {
    continue_past_errors(run_, continuation_, more_steps);
}

bool HeldRun::is_at_its_end() const {
    return run_.finished && checkpoint().step == steps_of_run(run_, checkpoint());
}

}  // namespace ljmd
