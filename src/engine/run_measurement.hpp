#pragma once

#include "ljmd/detail/core/archive.hpp"
#include "ljmd/detail/engine/time_loop.hpp"

namespace ljmd {

/// Measures a run during the time loop, and can be resumed with it.
class RunMeasurement : public StepObserver, public LoopControl {
  public:
    /// The run is resumed there; archive() is to read next.
    virtual void resume_at(const LoopPosition& position) = 0;

    /// Read or write everything that the rest of the run depends on, except outputs.
    virtual void archive(Archive& a) = 0;

    /// @throws CheckpointError unless what archive() has read belongs to the stages that have begun by then
    virtual void require_begun(const LoopPosition& position) const = 0;

  protected:
    RunMeasurement() = default;
    RunMeasurement(const RunMeasurement&) = default;
    RunMeasurement& operator=(const RunMeasurement&) = default;
};

}  // namespace ljmd
