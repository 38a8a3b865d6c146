#pragma once

#include "ljmd/core/archive.hpp"
#include "ljmd/core/types.hpp"
#include "ljmd/engine/snapshot.hpp"

namespace ljmd {

/// A measurement by the user of the engine, in the sampled stages of a run. It cannot change the trajectory. What it
/// throws ends the run.
class Observer {
  public:
    virtual ~Observer() = default;

    /// Whether sample() is to be called after this step of the run, counted from its start.
    [[nodiscard]] virtual bool needs(Index step) const = 0;

    /// Whether the snapshot must have energy and pressure. Without it, it has them only where they are known anyway.
    [[nodiscard]] virtual bool needs_energy() const { return false; }

    /// Measure. @param snapshot  valid during this call
    virtual void sample(const Snapshot& snapshot) = 0;

    /// Another stage begins: the next snapshot does not continue the last one.
    virtual void interrupt() {}

    /// Read or write everything that sampling has changed, for checkpoints.
    virtual void archive(Archive& /*a*/) {}

  protected:
    Observer() = default;
    Observer(const Observer&) = default;
    Observer& operator=(const Observer&) = default;
};

}  // namespace ljmd
