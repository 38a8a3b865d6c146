#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/deck/deck.hpp"
#include "ljmd/engine/phase_seconds.hpp"
#include "ljmd/execution/execution.hpp"
#include "ljmd/io/formats/trajectory_writer.hpp"

namespace ljmd {

/// The earlier parts of a resumed run, from its record.
struct EarlierParts {
    std::string began;
    std::vector<Index> resumed_at_steps;
    Index steps_added = 0;  ///< to the last stage of the deck, by `ljmd resume --steps`
};

/// XXH3 (64 bits) of the deck's text and of every --set: identifies what was run.
[[nodiscard]] std::string deck_hash(const Deck& deck);

/// run.json: what was run, by which program, where and when. Written at the beginning and the end of a run.
class RunRecord {
  public:
    /// @param execution  computes the run
    /// @param earlier    for a resumed run, including the step at which it is resumed
    /// @throws FileError
    RunRecord(const Deck& deck, Execution execution, const std::optional<EarlierParts>& earlier = std::nullopt);

    /// @param seconds  wall time of the time loop
    /// @param phases   its parts, if measured
    void finish(double seconds, const std::optional<PhaseSeconds>& phases = std::nullopt) const;

  private:
    void write(bool finished, double seconds, const std::optional<PhaseSeconds>& phases) const;

    const Deck& deck_;
    Execution execution_;
    std::string began_;
    std::vector<Index> resumed_at_steps_;
    Index steps_added_;
};

/// Create or continue the trajectory that a deck asks for, in H5MD or extended XYZ; null if it asks for none.
/// @param kept  committed part of an existing file, see TrajectoryOptions
/// @throws FileError, CheckpointError
[[nodiscard]] std::unique_ptr<TrajectoryWriter> open_trajectory(const Deck& deck, const State& first,
                                                                std::optional<CommittedFrames> kept = std::nullopt);

/// Write failed.xyz: the configuration at which a run failed, whatever it is. Its positions and velocities may belong
/// to different times, but they show where the run went wrong.
/// @return a line for the user; empty if the file cannot be written, because the failure itself matters more
[[nodiscard]] std::string save_failure(const Deck& deck, const State& state);

}  // namespace ljmd
