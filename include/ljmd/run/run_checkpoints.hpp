#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/core/archive.hpp"
#include "ljmd/deck/deck.hpp"
#include "ljmd/engine/time_loop.hpp"
#include "ljmd/io/files/checkpoint_file.hpp"
#include "ljmd/io/formats/trajectory_writer.hpp"
#include "ljmd/run/interruption.hpp"

namespace ljmd {

/// The parts of the growing output files that were on the disk; see OutputFile::commit and TrajectoryWriter::commit.
struct CommittedOutputs {
    std::int64_t thermo = 0;
    CommittedFrames trajectory;

    void archive(Archive& a) { a(thermo, trajectory); }
};

/// The part of a checkpoint before the run's own data.
struct CheckpointHead {
    std::string deck_hash;  ///< of the deck it belongs to
    std::string version;    ///< of the program that wrote it
    Index step = 0;         ///< last completed step
    Index atoms = 0;
    Vec3 edges = Vec3::Zero();  ///< of the box; zero without one
    LoopPosition position;
    CommittedOutputs outputs;

    void archive(Archive& a);
};

/// A checkpoint to resume from.
struct ResumePoint {
    CheckpointFile file;
    CheckpointHead head;
    std::vector<std::string> warnings;  ///< generations that could not be used

    /// Let a run read its own part.
    /// @param state  of the run; it must be at the step of the checkpoint afterwards  @throws CheckpointError
    void restore(const Deck& deck, const State& state, const std::function<void(Archive&)>& archive) const;
};

/// The newest intact checkpoint in the output directory of a deck; nothing if there is none at all.
/// @throws CheckpointError when all are damaged, or when it belongs to another deck or version, or cannot have been
/// written by a run of the deck
[[nodiscard]] std::optional<ResumePoint> find_resume_point(const Deck& deck);

/// Decides when a run writes checkpoints, and writes them.
class RunCheckpoints {
  public:
    /// @param interruption  when to stop
    /// @param generation    of the checkpoint that the run is resumed from; 0: none
    /// @param has_begun     called after the first checkpoint
    RunCheckpoints(const Deck& deck, const Interruption& interruption, std::uint64_t generation,
                   std::function<void()> has_begun);

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

    const Deck& deck_;
    CheckpointStore store_;
    Interruption interruption_;
    std::function<void()> has_begun_;
    Clock::time_point last_ = Clock::now();
    int calls_ = 0;
};

}  // namespace ljmd
