#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "ljmd/core/archive.hpp"
#include "ljmd/engine/stage.hpp"
#include "ljmd/forces/force_field.hpp"
#include "ljmd/model/state.hpp"
#include "ljmd/potentials/interaction.hpp"

namespace ljmd {

/// Wall time of a time loop [s]. The evaluation of the start is not counted.
struct LoopSeconds {
    double all = 0.0;
    double steps = 0.0;  ///< integrators, with the forces they ask for

    void archive(Archive& a) { a(all, steps); }
};

/// How far a time loop has come, from which it can go on.
struct LoopPosition {
    std::size_t stage = 0;    ///< by its place among the stages
    bool begun = false;       ///< it has; if not, nothing of it has happened
    Index steps = 0;          ///< of this stage that are done
    double first_time = 0.0;  ///< when it began [tau]
    LoopSeconds seconds;      ///< spent until here

    void archive(Archive& a) { a(stage, begun, steps, first_time, seconds); }
};

/// What happens around the steps of a run: measuring, writing, watching.
class StepObserver {
  public:
    virtual ~StepObserver() = default;

    /// The start has been evaluated, with energy.
    virtual void started(const Evaluation& evaluation) = 0;

    /// The integrator has done its start-up; if the stage is one that turns the motion round, that is still to come.
    virtual void stage_begins(const Stage& stage) = 0;

    /// Whether the potential energy is wanted after this step of the run.
    [[nodiscard]] virtual bool wants_energy(Index step) const = 0;

    /// Whether within_step() is wanted in this stage.
    [[nodiscard]] virtual bool looks_within_steps(const Stage& /*stage*/) const { return false; }

    /// What an adaptive integrator goes through in a step that is under way; times increase from the step's beginning
    /// to its end, both not among them. Other integrators know nothing in between.
    virtual void within_step(const Stage& /*stage*/, const State& /*moment*/) {}

    /// The integrator has moved the particles; what the thermostat does after a step is still to come.
    virtual void moved(Index step_of_stage) = 0;

    /// A step is complete; state.step and state.time are those at its end. What the barostat does is still to come.
    virtual void step_done(const Stage& stage, const Evaluation& evaluation) = 0;

    /// Whether checkpoint() is wanted now: after the start, and after every step.
    /// @param last_of_stage  also after the start
    [[nodiscard]] virtual bool wants_checkpoint(bool /*last_of_stage*/) { return false; }

    /// Everything is between two steps: from here the loop can go on another time. May throw, to end it.
    virtual void checkpoint(const LoopPosition& /*position*/) {}

    virtual void stage_ends(const Stage& stage) = 0;

  protected:
    StepObserver() = default;
    StepObserver(const StepObserver&) = default;
    StepObserver& operator=(const StepObserver&) = default;
};

/// The one time loop: evaluates the start, then takes every step of every stage.
///
/// Time grows in all stages, also in those that run the motion backwards. Where momentum is conserved again after a
/// thermostat that does not, the centre of mass is brought to rest.
/// @param from  go on from there: state, force field and observer are what they were at that checkpoint
/// @param interaction  of a fluid; barostats need it
/// @throws PhysicsError naming the step and the stage
/// @throws CheckpointError when the state has not what the thermostat keeps
LoopSeconds run_stages(const std::vector<Stage>& stages, State& state, ForceField& force_field, StepObserver& observer,
                       const std::optional<LoopPosition>& from = std::nullopt,
                       const std::optional<Interaction>& interaction = std::nullopt);

}  // namespace ljmd
