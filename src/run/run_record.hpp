#pragma once

#include <memory>
#include <optional>
#include <string>

#include "deck/deck.hpp"
#include "io/formats/trajectory_writer.hpp"
#include "ljmd/detail/engine/phase_seconds.hpp"
#include "ljmd/execution/execution.hpp"
#include "run/continuation.hpp"

namespace ljmd {

/// XXH3 (64 bits) of the deck's text, of every --set, and of the pair potential that a program gave: identifies what
/// was run.
[[nodiscard]] std::string deck_hash(const RunPlan& plan);

/// How a run that was to reach errors has ended.
struct UntilEnd {
    bool reached;  ///< before its max_steps
    Index steps;   ///< taken in all stages
};

/// run.json: what was run, by which program, where and when. Written at the beginning and the end of a run; at the
/// beginning also the table of a pair potential that a program gave, which the record names.
class RunRecord {
  public:
    /// @param execution     computes the run
    /// @param continuation  from where it is resumed, if it is
    /// @throws FileError
    RunRecord(const RunPlan& plan, Execution execution, const std::optional<Continuation>& continuation = std::nullopt);

    /// @param seconds  wall time of the time loop
    /// @param phases   its parts, if measured
    /// @param until    of a run that was to reach errors
    void finish(double seconds, const std::optional<PhaseSeconds>& phases = std::nullopt,
                const std::optional<UntilEnd>& until = std::nullopt);

  private:
    void write(bool finished, double seconds, const std::optional<PhaseSeconds>& phases) const;

    const RunPlan& plan_;
    Execution execution_;
    EarlierParts parts_;
    std::optional<UntilEnd> until_;
};

/// Create or continue the trajectory that a deck asks for, in H5MD or extended XYZ; null if it asks for none.
/// @param continuation  from where the run is resumed, if it is
/// @throws FileError, CheckpointError
[[nodiscard]] std::unique_ptr<TrajectoryWriter> open_trajectory(
    const RunPlan& plan, const State& first, const std::optional<Continuation>& continuation = std::nullopt);

/// Write failed.xyz: the configuration at which a run failed, whatever it is. Its positions and velocities may belong
/// to different times, but they show where the run went wrong.
/// @return a line for the user; empty if the file cannot be written, because the failure itself matters more
[[nodiscard]] std::string save_failure(const RunPlan& plan, const State& state);

}  // namespace ljmd
