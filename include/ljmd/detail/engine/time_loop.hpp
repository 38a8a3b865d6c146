#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "ljmd/detail/core/archive.hpp"
#include "ljmd/detail/engine/energy_start.hpp"
#include "ljmd/detail/forces/force_field.hpp"
#include "ljmd/detail/model/state.hpp"
#include "ljmd/detail/potentials/interaction.hpp"
#include "ljmd/engine/stage.hpp"

namespace ljmd {

/// Wall time of a time loop [s], without the evaluation of the start.
struct LoopSeconds {
    double all = 0.0;
    double steps = 0.0;  ///< integrators with their forces, and thermostats

    void archive(Archive& a) { a(all, steps); }
};

/// Position of a time loop between two steps, from which it can be resumed.
struct LoopPosition {
    std::size_t stage = 0;    ///< index of the stage
    bool begun = false;       ///< false: nothing of the stage has happened yet
    Index steps = 0;          ///< steps of the stage that are done
    double first_time = 0.0;  ///< time at which the stage began [tau]
    bool enough = false;      ///< the stage ends here, before its last step: its errors are reached
    LoopSeconds seconds;      ///< spent so far

    void archive(Archive& a) { a(stage, begun, steps, first_time, enough, seconds); }
};

/// Called around the steps of a run, to measure and watch.
class StepObserver {
  public:
    virtual ~StepObserver() = default;

    /// The start has been evaluated, with energy.
    virtual void started(const Evaluation& /*evaluation*/) {}

    /// The integrator has done its start-up. If the stage reverses the motion, that comes next.
    virtual void stage_begins(const Stage& /*stage*/) {}

    /// The velocities of the stage that has just begun were scaled, before the start-up of the integrator.
    virtual void energy_set(const EnergyStart& /*start*/) {}

    /// Whether the potential energy is needed after this step of the run.
    [[nodiscard]] virtual bool wants_energy(Index step) const = 0;

    /// Whether moved() or step_done() read velocities after the step that was just taken. Reading them costs a pass
    /// over the atoms, see State::kick. @param step_of_stage  1 after the first step
    [[nodiscard]] virtual bool reads_velocities(Index /*step_of_stage*/) const { return true; }

    /// The integrator has moved the particles. The thermostat may still act.
    virtual void moved(Index /*step_of_stage*/) {}

    /// A step is complete; state.step and state.time belong to its end. The barostat may still act.
    virtual void step_done(const Stage& stage, const Evaluation& evaluation) = 0;

    virtual void stage_ends(const Stage& /*stage*/) {}

  protected:
    StepObserver() = default;
    StepObserver(const StepObserver&) = default;
    StepObserver& operator=(const StepObserver&) = default;
};

/// Shown the states that adaptive integrators pass through within a step.
class MomentObserver {
  public:
    virtual ~MomentObserver() = default;

    /// Whether within_step() is to be called in this stage.
    [[nodiscard]] virtual bool looks_within_steps(const Stage& stage) const = 0;

    /// A state between the beginning and the end of the present step, in order of time, both ends excluded.
    virtual void within_step(const Stage& stage, const State& moment) = 0;

  protected:
    MomentObserver() = default;
    MomentObserver(const MomentObserver&) = default;
    MomentObserver& operator=(const MomentObserver&) = default;
};

/// Decides when a stage has enough steps, and when the run is saved.
class LoopControl {
  public:
    virtual ~LoopControl() = default;

    /// Whether the stage ends after this step, because the errors that it was to reach are reached. Asked after every
    /// step.
    [[nodiscard]] virtual bool has_enough(const Stage& /*stage*/) { return false; }

    /// Whether checkpoint() is to be called now. Asked after the start and after every step.
    /// @param last_of_stage  true also after the start
    [[nodiscard]] virtual bool wants_checkpoint(bool last_of_stage) = 0;

    /// The loop is between two steps and can be resumed from here. May throw, to end the loop.
    virtual void checkpoint(const LoopPosition& position) = 0;

  protected:
    LoopControl() = default;
    LoopControl(const LoopControl&) = default;
    LoopControl& operator=(const LoopControl&) = default;
};

/// Who takes part in a time loop beside what moves.
struct LoopParty {
    StepObserver& observer;
    LoopControl* control = nullptr;     ///< null: all steps, and nothing is saved
    MomentObserver* moments = nullptr;  ///< null: nobody looks within steps
};

/// The time loop: evaluates the start, then takes every step of every stage.
///
/// Time increases in all stages, also in those that run the motion backwards. The centre of mass is brought to rest at
/// the beginning of a stage that conserves momentum, if the stage before it did not. Under an external force it is
/// left as it is; then thermostats that would conserve momentum act on the motion about it.
/// @param from  position to continue from; state, force field and observer are as they were then
/// @param interaction  of a fluid; needed by barostats, and where there is an external force
/// @param until  last step of the run to take; none: the last one of the stages
/// @return the position after the last step that was taken; its stage is stages.size() when all is done
/// @throws PhysicsError naming the step and the stage
/// @throws CheckpointError if the state lacks the variables of the thermostat
LoopPosition run_stages(const std::vector<Stage>& stages, State& state, ForceField& force_field, const LoopParty& party,
                        const std::optional<LoopPosition>& from = std::nullopt,
                        const std::optional<Interaction>& interaction = std::nullopt,
                        std::optional<Index> until = std::nullopt);

}  // namespace ljmd
