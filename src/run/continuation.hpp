#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "deck/deck.hpp"
#include "io/files/checkpoint_file.hpp"
#include "io/formats/trajectory_writer.hpp"
#include "ljmd/detail/core/archive.hpp"
#include "ljmd/detail/engine/time_loop.hpp"

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

/// The earlier parts of a resumed run, from its record.
struct EarlierParts {
    std::string began;
    std::vector<Index> resumed_at_steps;
    Index steps_added = 0;  ///< to the last stage of the deck, by `ljmd resume --steps`

    /// Steps of the last stage, if `until` had ended it when steps were added: it takes that many, whatever its errors.
    std::optional<Index> last_stage_steps = {};
};

/// From where a stopped run is resumed: its state, how much of each output file belongs to it, and its record.
struct Continuation {
    CheckpointFile file;
    CheckpointHead head;
    EarlierParts earlier;               ///< with the step at which the run is resumed now
    std::vector<std::string> warnings;  ///< generations of the checkpoint that could not be used

    /// Let a run read its own part of the checkpoint.
    /// @param state  of the run; it must be at the step of the checkpoint afterwards  @throws CheckpointError
    void restore(const RunPlan& plan, const State& state, const std::function<void(Archive&)>& archive) const;
};

/// The continuation from the newest intact checkpoint in the output directory of a deck; nothing if there is none at
/// all.
/// @param earlier  the record of the run so far
/// @throws CheckpointError when all are damaged, or when it belongs to another deck or version, or cannot have been
/// written by a run of the deck
[[nodiscard]] std::optional<Continuation> find_continuation(const RunPlan& plan, EarlierParts earlier = {});

/// What a run keeps of one of its files; nothing in a run that begins.
template <class Part>
[[nodiscard]] std::optional<Part> kept(const std::optional<Continuation>& continuation, Part CommittedOutputs::*file) {
    return continuation ? std::optional(continuation->head.outputs.*file) : std::nullopt;
}

}  // namespace ljmd
