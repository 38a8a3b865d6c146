#include "ljmd/detail/engine/time_loop.hpp"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "core/stopwatch.hpp"
#include "execution/first_touch.hpp"
#include "integrators/barostat.hpp"
#include "integrators/integrator.hpp"
#include "integrators/thermostat.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/observables/thermodynamics.hpp"
#include "model/velocities.hpp"

namespace ljmd {

namespace {

/// The objects that a stage works with.
struct StageParts {
    std::unique_ptr<Thermostat> thermostat;
    std::unique_ptr<Barostat> barostat;
    Integrator integrator;
    bool rest_needed;  ///< around every act of the thermostat, see CentreAtRest
};

std::unique_ptr<Thermostat> thermostat_of(const Stage& stage, const State& state) {
    if (!stage.thermostat) {
        return nullptr;
    }
    return chosen_thermostat(*stage.thermostat)
        .options->make({stage.temperature.value(), stage.time_step, stage.seed, degrees_of_freedom(state.total())});
}

std::unique_ptr<Barostat> barostat_of(const Stage& stage, const std::optional<Interaction>& interaction) {
    if (!stage.barostat) {
        return nullptr;
    }
    if (!interaction) {
        throw ContractViolation("a barostat needs to know the interaction");
    }
    const double shortest_edge = 2.0 * interaction->potential.cutoff().radius;
    return chosen_barostat(*stage.barostat)
        .options->make({stage.temperature.value(), stage.time_step, stage.seed, shortest_edge});
}

Integrator integrator_of(const Stage& stage, const Thermostat* thermostat) {
    Integrator integrator(chosen_integrator(stage.integrator), stage.time_step);
    if (thermostat == nullptr || !thermostat->acts_mid_drift()) {
        return integrator;
    }
    return integrator.with_mid_drift([thermostat](State& state) { thermostat->mid_drift(state); });
}

bool thermostat_conserves_momentum(const Stage& stage) {
    return !stage.thermostat || find_thermostat(stage.thermostat->name).conserves_momentum;
}

/// Brings the centre of mass to rest for as long as this lives, for thermostats that would conserve its momentum but
/// find it moving under an external force. They thermalise the 3 N - 3 degrees of freedom about it: scaling these alone
/// keeps Maxwell's distribution, whatever the centre of mass does.
class CentreAtRest {
  public:
    explicit CentreAtRest(State& state) : state_(state) {
        state_.finish_kick();
        velocity_ = centre_velocity(state_);
        shift_velocities(state_, -velocity_);
    }
    ~CentreAtRest() { shift_velocities(state_, velocity_); }
    CentreAtRest(const CentreAtRest&) = delete;
    CentreAtRest& operator=(const CentreAtRest&) = delete;

  private:
    State& state_;
    Vec3 velocity_;
};

class TimeLoop {
  public:
    TimeLoop(const std::vector<Stage>& stages, State& state, ForceField& force_field, const LoopParty& party,
             const LoopPosition& from, const std::optional<Interaction>& interaction, std::optional<Index> until)
        : stages_(stages),
          state_(state),
          force_field_(force_field),
          observer_(party.observer),
          control_(party.control),
          moments_(party.moments),
          interaction_(interaction),
          until_(until),
          position_(from),
          step_(state.step) {}

    LoopPosition run() {
        while (position_.stage < stages_.size() && !is_reached()) {
            run_stage(stages_[position_.stage]);
            if (!position_.begun) {
                ++position_.stage;
            }
        }
        state_.finish_kick();
        note_seconds();
        return position_;
    }

    /// Have the run saved where that is due.
    void offer_checkpoint(bool last_of_stage) {
        if (control_ != nullptr && control_->wants_checkpoint(last_of_stage)) {
            note_seconds();
            state_.finish_kick();
            control_->checkpoint(position_);
        }
    }

    /// Step of the run; while a step fails, the number of that step.
    [[nodiscard]] Index step() const { return step_; }

    /// Name of the present stage, for messages.
    [[nodiscard]] std::string where() const {
        return position_.begun ? fmt::format(" (stage '{}')", stages_[position_.stage].name) : "";
    }

  private:
    [[nodiscard]] bool is_reached() const { return until_ && step_ >= *until_; }

    /// Take the steps of a stage that are left; its position says whether the stage was ended.
    void run_stage(const Stage& stage) {
        std::unique_ptr<Thermostat> thermostat = thermostat_of(stage, state_);
        Integrator integrator = integrator_of(stage, thermostat.get());
        const bool rest_needed = has_external_force() && stage.thermostat && thermostat_conserves_momentum(stage) &&
                                 find_thermostat(stage.thermostat->name).every_step;
        const StageParts parts{std::move(thermostat), barostat_of(stage, interaction_), std::move(integrator),
                               rest_needed};
        const std::vector<double> bath = parts.thermostat ? parts.thermostat->beginning() : std::vector<double>();
        if (!position_.begun) {
            state_.bath = bath;
            begin(stage, parts.integrator);
        } else if (state_.bath.size() != bath.size()) {
            throw CheckpointError("the checkpoint has another thermostat than the run");
        }
        while (position_.steps < stage.steps && !position_.enough) {
            if (is_reached()) {
                return;
            }
            take_step(stage, parts);
            position_.enough = control_ != nullptr && control_->has_enough(stage);
            offer_checkpoint(position_.steps == stage.steps || position_.enough);
        }
        observer_.stage_ends(stage);
        position_.begun = false;
        position_.enough = false;
    }

    void begin(const Stage& stage, const Integrator& integrator) {
        state_.finish_kick();
        position_.begun = true;
        position_.steps = 0;
        position_.first_time = state_.time;
        if (position_.stage > 0 && !has_external_force() && thermostat_conserves_momentum(stage) &&
            !thermostat_conserves_momentum(stages_[position_.stage - 1])) {
            remove_momentum(state_);
        }
        std::optional<EnergyStart> energy_start;
        if (stage.total_energy) {
            energy_start = set_energy(*stage.total_energy);
        }
        integrator.prepare(state_, force_field_);
        observer_.stage_begins(stage);
        if (energy_start) {
            observer_.energy_set(*energy_start);
        }
        if (stage.reverse) {
            integrator.reverse(state_, force_field_);
        }
    }

    [[nodiscard]] EnergyStart set_energy(double total_energy) {
        if (!interaction_) {
            throw ContractViolation("a total energy needs to know the interaction");
        }
        const Evaluation evaluation = force_field_.evaluate(state_, Request::forces_and_energy);
        return scale_to_total_energy(state_, thermodynamics(state_, evaluation, interaction_->tail), total_energy);
    }

    void take_step(const Stage& stage, const StageParts& parts) {
        ++step_;
        Stopwatch watch;
        const Index n = ++position_.steps;
        const bool pressure_wanted = parts.barostat && parts.barostat->due(n);
        if (parts.thermostat) {
            thermalise(parts, [&] { parts.thermostat->before_step(state_); });
        }
        const double end = position_.first_time + static_cast<double>(n) * stage.time_step;
        const Evaluation evaluation = parts.integrator.step_with_pending_kick(
            state_, force_field_,
            {.energy = pressure_wanted || observer_.wants_energy(step_), .order_independent = false},
            watch_within(stage, end));
        state_.step = step_;
        state_.time = end;
        position_.seconds.steps += watch.lap();
        if (observer_.reads_velocities(n)) {
            state_.finish_kick();
        }
        observer_.moved(n);
        watch.lap();
        if (parts.thermostat) {
            thermalise(parts, [&] { parts.thermostat->after_step(state_, n); });
            position_.seconds.steps += watch.lap();
        }
        observer_.step_done(stage, evaluation);
        if (pressure_wanted) {
            parts.barostat->apply(state_, {virial_pressure(state_, evaluation, interaction_->tail),
                                           virial_pressures(state_, evaluation, interaction_->tail)});
        }
    }

    [[nodiscard]] bool has_external_force() const { return interaction_ && interaction_->external; }

    /// Let the thermostat of a stage act. One that is not due at every step must not end the integrator's phase in
    /// between; it scales the motion of the centre of mass, too, and holds the temperature about it all the same.
    template <class Act>
    void thermalise(const StageParts& parts, const Act& act) {
        std::optional<CentreAtRest> at_rest;
        if (parts.rest_needed) {
            at_rest.emplace(state_);
        }
        act();
    }

    /// Pass on the states strictly between now and the end of the step; their times are rounded, too.
    [[nodiscard]] StateWatch watch_within(const Stage& stage, double end) {
        if (moments_ == nullptr || !moments_->looks_within_steps(stage)) {
            return {};
        }
        return [this, &stage, end, last = state_.time](const State& moment) mutable {
            if (moment.time > last && moment.time < end) {
                last = moment.time;
                moments_->within_step(stage, moment);
            }
        };
    }

    void note_seconds() { position_.seconds.all += watch_.lap(); }

    const std::vector<Stage>& stages_;
    State& state_;
    ForceField& force_field_;
    StepObserver& observer_;
    LoopControl* control_;
    MomentObserver* moments_;
    const std::optional<Interaction>& interaction_;
    std::optional<Index> until_;
    LoopPosition position_;
    Stopwatch watch_;
    Index step_;
};

}  // namespace

LoopPosition run_stages(const std::vector<Stage>& stages, State& state, ForceField& force_field, const LoopParty& party,
                        const std::optional<LoopPosition>& from, const std::optional<Interaction>& interaction,
                        std::optional<Index> until) {
    const FirstTouch first_touch(touched_by_threads(state.execution()));
    std::optional<TimeLoop> loop;
    try {
        if (!from) {
            party.observer.started(force_field.evaluate(state, Request::forces_and_energy));
        }
        loop.emplace(stages, state, force_field, party, from.value_or(LoopPosition{}), interaction, until);
        if (!from) {
            loop->offer_checkpoint(true);
        }
        return loop->run();
    } catch (const PhysicsError& error) {
        throw PhysicsError(
            fmt::format("step {}{}: {}", loop ? loop->step() : state.step, loop ? loop->where() : "", error.what()));
    }
}

}  // namespace ljmd
