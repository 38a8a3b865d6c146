#pragma once

#include <memory>
#include <optional>
#include <string>

#include "ljmd/app/deck.hpp"
#include "ljmd/app/phase_seconds.hpp"
#include "ljmd/io/trajectory_writer.hpp"

namespace ljmd {

/// run.json: what was run, by which program, where and when. Written when the run begins and again when it ends.
class RunRecord {
  public:
    /// @throws FileError
    explicit RunRecord(const Deck& deck);

    /// @param seconds  wall time of the time loop
    /// @param phases   where it went, if that was measured
    void finish(double seconds, const std::optional<PhaseSeconds>& phases = std::nullopt) const;

  private:
    void write(bool finished, double seconds, const std::optional<PhaseSeconds>& phases) const;

    const Deck& deck_;
    std::string began_;
};

/// The trajectory that a deck asks for, in H5MD or extended XYZ; nothing when it asks for none. @throws FileError
[[nodiscard]] std::unique_ptr<TrajectoryWriter> open_trajectory(const Deck& deck, const State& first);

/// failed.xyz: the configuration at which a run was given up, whatever it is. Its positions and velocities may belong
/// to no one time, but they show where it went wrong.
/// @return what to tell the user of it; nothing when it cannot be written: the failure itself is what matters
[[nodiscard]] std::string save_failure(const Deck& deck, const State& state);

}  // namespace ljmd
