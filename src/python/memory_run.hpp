#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/document.hpp"
#include "deck/checked_run.hpp"
#include "deck/deck.hpp"
#include "ljmd/detail/model/state.hpp"
#include "ljmd/detail/observables/analysis.hpp"
#include "ljmd/engine/observer.hpp"
#include "ljmd/forces/external_force.hpp"

namespace ljmd::python {

/// A run of a deck in memory, of a fluid or of few bodies, taken some steps at a time. It has the bits of the same deck
/// run with a directory.
class MemoryRun {
  public:
    virtual ~MemoryRun() = default;

    /// Take some steps; fewer if the stages end before. The first call evaluates the start.
    /// @throws as Simulation::advance()
    virtual void advance(Index steps) = 0;

    [[nodiscard]] virtual bool finished() const = 0;
    [[nodiscard]] virtual const State& state() const = 0;
    [[nodiscard]] virtual const std::vector<Stage>& stages() const = 0;
    /// With `until` in the last stage the largest number of them.
    [[nodiscard]] Index steps_left() const { return finished() ? 0 : total_steps(stages()) - state().step; }

    /// Energies and what else results.json has of one moment, of the present one.
    [[nodiscard]] virtual Data now() const = 0;

    /// The results so far, as in results.json.
    [[nodiscard]] virtual Document report() const = 0;
    [[nodiscard]] virtual std::vector<DataTable> tables() const = 0;

    /// The rows of thermo.csv so far. What is undefined is NaN.
    [[nodiscard]] virtual DataTable thermo() const = 0;

    /// Let an observer measure. @throws InputError for few bodies
    virtual void add(Observer& observer) = 0;

    // Of fluids, see Simulation. @throws InputError for few bodies
    [[nodiscard]] virtual std::string checkpoint() const = 0;
    virtual void restore(const std::string& checkpoint) = 0;

  protected:
    MemoryRun() = default;
    MemoryRun(const MemoryRun&) = default;
    MemoryRun& operator=(const MemoryRun&) = default;
};

/// @param external  force of the program on the atoms of a fluid; null: none
/// @param warn      receives remarks on the start
/// @throws InputError, DataError, PhysicsError as make_fluid()
[[nodiscard]] std::unique_ptr<MemoryRun> memory_run(const Deck& deck, CheckedRun checked,
                                                    const std::shared_ptr<ExternalForce>& external,
                                                    const std::function<void(const std::string&)>& warn);

}  // namespace ljmd::python
