#pragma once

#include <optional>
#include <string>

#include "ljmd/core/types.hpp"
#include "ljmd/detail/core/archive.hpp"
#include "ljmd/detail/observables/statistics/observable_average.hpp"
#include "ljmd/engine/snapshot.hpp"

namespace ljmd {

/// What the record of a run says of an observer: by it is known whether a run is resumed with the same ones.
struct ObserverRecord {
    std::string name = {};  ///< may be empty
    std::string unit = {};
    Index every = 0;  ///< steps between samples; 0: not regular
    bool energy = false;

    friend bool operator==(const ObserverRecord&, const ObserverRecord&) = default;
};

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

    /// What run.json says of it, in a run with a directory.
    [[nodiscard]] virtual ObserverRecord record() const { return {.energy = needs_energy()}; }

    /// Its result so far, for the results of the run; nothing if the program keeps it to itself.
    [[nodiscard]] virtual std::optional<ObservableAverage> average() const { return std::nullopt; }

  protected:
    Observer() = default;
    Observer(const Observer&) = default;
    Observer& operator=(const Observer&) = default;
};

}  // namespace ljmd
