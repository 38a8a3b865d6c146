#pragma once

#include <chrono>
#include <functional>
#include <optional>

#include "deck/deck.hpp"
#include "io/files/checkpoint_file.hpp"
#include "ljmd/detail/core/archive.hpp"
#include "ljmd/detail/engine/time_loop.hpp"
#include "ljmd/detail/run/interruption.hpp"
#include "run/continuation.hpp"

namespace ljmd {

/// Decides when a run writes checkpoints, and writes them.
class RunCheckpoints {
  public:
    /// @param interruption  when to stop
    /// @param continuation  from where the run is resumed, if it is
    /// @param has_begun     called after the first checkpoint
    RunCheckpoints(const RunPlan& plan, const Interruption& interruption,
                   const std::optional<Continuation>& continuation, std::function<void()> has_begun);

    /// Whether to write a checkpoint after this step. @param last_of_stage  the step is the last one of its stage
    [[nodiscard]] bool due(Index step, bool last_of_stage);

    /// Write a checkpoint, and stop the run if that was requested.
    /// @param outputs  their parts on the disk
    /// @param archive  writes the run's own part
    /// @throws FileError, Interrupted
    void write(const State& state, const LoopPosition& position, const CommittedOutputs& outputs,
               const std::function<void(Archive&)>& archive);

  private:
    using Clock = std::chrono::steady_clock;

    const RunPlan& plan_;
    CheckpointStore store_;
    Interruption interruption_;
    std::function<void()> has_begun_;
    Clock::time_point last_ = Clock::now();
    int calls_ = 0;
};

}  // namespace ljmd
