#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ljmd/execution/execution.hpp"
#include "run/continuation.hpp"
#include "run/given/given_record.hpp"
#include "run/recorded_run.hpp"
#include "run/run_lock.hpp"

namespace ljmd {

/// A run whose directory is locked, so that it can be resumed from its newest checkpoint.
class HeldRun {
  public:
    /// @param more_steps  added to the last stage, besides those added earlier
    /// @param threads     their number; 0: as many as before
    /// @throws DataError        it is not the directory of a run
    /// @param ranks       that share the run; rank 0 locks the directory. Null: this process alone
    /// @param again       what the caller gives to the run beside its deck; the command line gives nothing
    /// @throws CheckpointError  there is no checkpoint that can be used; the run was begun with other potentials or
    /// observers of a program
    /// @throws InputError       too many steps; a SIMD level that this processor does not have
    /// @throws InUseError, FileError, ThreadsError
    HeldRun(const std::filesystem::path& directory, Index more_steps, int threads, const RunLock::Warn& warn,
            const GivenAgain& again = {}, const std::shared_ptr<Ranks>& ranks = nullptr);

    [[nodiscard]] const Deck& deck() const { return run_.deck; }
    [[nodiscard]] const CheckpointHead& checkpoint() const { return continuation_.head; }
    [[nodiscard]] const std::string& checkpoint_hash() const { return continuation_.file.hash; }
    [[nodiscard]] const Execution& execution() const { return execution_; }

    /// Checkpoints that could not be used.
    [[nodiscard]] const std::vector<std::string>& warnings() const { return continuation_.warnings; }

    /// Whether the run has come to its end; resuming it writes its results anew.
    [[nodiscard]] bool is_at_its_end() const;

    /// From where run_plan() continues. It is handed over: checkpoint() and warnings() are empty then.
    [[nodiscard]] Continuation take() { return std::move(continuation_); }

    /// See RunLock.
    void warn_if_moved() const {
        if (lock_) {
            lock_->warn_if_moved();
        }
    }

  private:
    std::unique_ptr<RunLock> lock_;  ///< null at the ranks that have no files
    RecordedRun run_;
    Continuation continuation_;
    Execution execution_;
};

}  // namespace ljmd
