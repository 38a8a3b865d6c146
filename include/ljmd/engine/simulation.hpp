#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/detail/engine/run_outputs.hpp"
#include "ljmd/engine/fluid_spec.hpp"
#include "ljmd/engine/observer.hpp"
#include "ljmd/engine/run_result.hpp"
#include "ljmd/execution/execution.hpp"

namespace ljmd {

/// A run of a fluid in memory: no deck, no directory, no output.
///
///     FluidSpec argon{.density = 0.8442, .temperature = 0.722};
///     argon.stages = {{.name = "equilibration", .time_step = 0.004, .steps = 2000, .temperature = 0.722,
///                      .thermostat = thermostat("langevin")},
///                     {.name = "production", .time_step = 0.004, .steps = 10000, .sample = true}};
///     Simulation simulation(argon);
///     const RunResult result = simulation.run();
///     const Estimate pressure = result.observable("pressure").estimate.value();
///
/// Every failure is an Error with a message; only memory that is not there is std::bad_alloc. A simulation that was
/// moved to another one can be assigned to and destroyed; all else is an InputError.
///
/// Several simulations may run at the same time, each in a thread of its own. The same specification gives the same
/// trajectory, to the last bit, as a deck that says the same.
class Simulation {
  public:
    /// Place the atoms and draw their velocities. Stages whose seed is 0 get the specification's, as in a deck.
    /// @throws InputError with all mistakes of the specification; DataError, PhysicsError  see make_fluid()
    explicit Simulation(FluidSpec spec, const Execution& execution = {});
    ~Simulation();
    Simulation(Simulation&&) noexcept;
    Simulation& operator=(Simulation&&) noexcept;
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;

    /// Let an observer measure from the next step on. @pre the observer lives as long as the simulation
    /// @throws InputError if it measures already
    void add(Observer& observer);

    /// Take all steps that are left.
    /// @throws PhysicsError naming step and stage, when the run blows up; what an observer throws. After either the
    /// simulation can be looked at, but not be continued (InputError).
    RunResult run();

    /// Take some steps; fewer if the stages end before. The first call also evaluates the start, so that advance(0)
    /// gives its energy and pressure. @throws InputError for fewer than 0; as run()
    void advance(Index steps);

    [[nodiscard]] bool finished() const;

    /// Results so far; stages that have begun are among them. Nothing is known before the first call of run() or
    /// advance().
    [[nodiscard]] RunResult result() const;

    [[nodiscard]] const FluidSpec& spec() const;
    /// The atoms as they are now. Forces belong to the positions once a step was taken.
    [[nodiscard]] const State& state() const;
    /// All samples since the simulation was made or restored: of the start, with the first call of run() or advance(),
    /// and then every `sample_every` steps.
    [[nodiscard]] const std::vector<ThermoRow>& samples() const;
    /// Energies per atom, temperature and pressure of the atoms as they are now: from the last sample, if it is of this
    /// step. Otherwise the forces are evaluated on a copy, which takes as long as a step that rebuilds the list, and
    /// changes nothing.
    [[nodiscard]] Thermodynamics thermodynamics() const;
    /// Remarks on the start, for the user.
    [[nodiscard]] const std::vector<std::string>& warnings() const;

    /// Everything that the rest of the run depends on, observers included.
    [[nodiscard]] std::string checkpoint() const;

    /// Continue from a checkpoint() of a simulation with the same specification and observers; the rest of the
    /// trajectory is the same to the last bit. Samples before it are not kept.
    /// @throws CheckpointError if it is damaged, or of another specification or precision, or of other observers; the
    /// simulation cannot be continued then
    void restore(const std::string& checkpoint);

  private:
    struct Parts;
    /// @throws InputError if this was moved to another one
    [[nodiscard]] Parts& parts() const;

    std::unique_ptr<Parts> parts_;
};

}  // namespace ljmd
