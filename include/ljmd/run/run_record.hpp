#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/deck/deck.hpp"
#include "ljmd/engine/phase_seconds.hpp"
#include "ljmd/io/formats/trajectory_writer.hpp"

namespace ljmd {

/// What the record of a run that is gone on with tells of its earlier parts.
struct EarlierParts {
    std::string began;
    std::vector<Index> resumed_at_steps;
    Index steps_added = 0;  ///< to the last stage of the deck, by `ljmd resume --steps`
};

/// XXH3 (64 bits) of the deck's text and of every --set, so that two runs can be told apart.
[[nodiscard]] std::string deck_hash(const Deck& deck);

/// run.json: what was run, by which program, where and when. Written when the run begins and again when it ends.
class RunRecord {
  public:
    /// @param earlier  of a run that is gone on with, the step included at which it is now  @throws FileError
    explicit RunRecord(const Deck& deck, const std::optional<EarlierParts>& earlier = std::nullopt);

    /// @param seconds  wall time of the time loop
    /// @param phases   where it went, if that was measured
    void finish(double seconds, const std::optional<PhaseSeconds>& phases = std::nullopt) const;

  private:
    void write(bool finished, double seconds, const std::optional<PhaseSeconds>& phases) const;

    const Deck& deck_;
    std::string began_;
    std::vector<Index> resumed_at_steps_;
    Index steps_added_;
};

/// The trajectory that a deck asks for, in H5MD or extended XYZ; nothing when it asks for none.
/// @param kept  what of an existing one to go on with, see TrajectoryOptions
/// @throws FileError, CheckpointError
[[nodiscard]] std::unique_ptr<TrajectoryWriter> open_trajectory(const Deck& deck, const State& first,
                                                                std::optional<CommittedFrames> kept = std::nullopt);

/// failed.xyz: the configuration at which a run was given up, whatever it is. Its positions and velocities may belong
/// to no one time, but they show where it went wrong.
/// @return what to tell the user of it; nothing when it cannot be written: the failure itself is what matters
[[nodiscard]] std::string save_failure(const Deck& deck, const State& state);

}  // namespace ljmd
