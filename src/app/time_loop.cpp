#include "ljmd/app/time_loop.hpp"

#include <fmt/format.h>

#include <memory>

#include "ljmd/app/run_record.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/core/stopwatch.hpp"
#include "ljmd/integrators/integrator.hpp"
#include "ljmd/integrators/thermostat.hpp"

namespace ljmd {

namespace {

std::unique_ptr<Thermostat> thermostat_of(const Stage& stage) {
    if (!stage.section.has("thermostat")) {
        return nullptr;
    }
    const Section& section = stage.section.section("thermostat");
    return find_thermostat(section.text("type")).make(section, stage.temperature);
}

/// One pass over the stages.
class TimeLoop {
  public:
    TimeLoop(const std::vector<Stage>& stages, State& state, ForceField& force_field, StepObserver& observer,
             const LoopPosition& from)
        : stages_(stages),
          state_(state),
          force_field_(force_field),
          observer_(observer),
          position_(from),
          step_(state.step) {}

    LoopSeconds run() {
        for (; position_.stage < stages_.size(); ++position_.stage) {
            run_stage(stages_[position_.stage]);
        }
        note_seconds();
        return position_.seconds;
    }

    /// Let the observer have its checkpoint, if it wants one.
    void offer_checkpoint(bool last_of_stage) {
        if (observer_.wants_checkpoint(last_of_stage)) {
            note_seconds();
            observer_.checkpoint(position_);
        }
    }

    /// Of the run; that of a step which fails is the one that failed.
    [[nodiscard]] Index step() const { return step_; }

    /// For messages.
    [[nodiscard]] std::string where() const {
        return position_.begun ? fmt::format(" (stage '{}')", stages_[position_.stage].name) : "";
    }

  private:
    void run_stage(const Stage& stage) {
        const Integrator integrator(find_integrator(stage.integrator), stage.time_step, stage.section);
        if (!position_.begun) {
            position_.begun = true;
            position_.steps = 0;
            position_.first_time = state_.time;
            integrator.prepare(state_, force_field_);
            observer_.stage_begins(stage);
            if (stage.reverse) {
                integrator.reverse(state_, force_field_);
            }
        }
        const std::unique_ptr<Thermostat> thermostat = thermostat_of(stage);
        while (position_.steps < stage.steps) {
            take_step(stage, integrator, thermostat.get());
            offer_checkpoint(position_.steps == stage.steps);
        }
        observer_.stage_ends(stage);
        position_.begun = false;
    }

    void take_step(const Stage& stage, const Integrator& integrator, Thermostat* thermostat) {
        ++step_;
        Stopwatch watch;
        const Evaluation evaluation = integrator.step(
            state_, force_field_, {.energy = observer_.wants_energy(step_), .order_independent = false});
        position_.seconds.steps += watch.lap();
        const Index n = ++position_.steps;
        state_.step = step_;
        state_.time = position_.first_time + static_cast<double>(n) * stage.time_step;
        observer_.moved(n);
        if (thermostat != nullptr) {
            thermostat->apply(state_, n);
        }
        observer_.step_done(stage, evaluation);
    }

    void note_seconds() { position_.seconds.all += watch_.lap(); }

    const std::vector<Stage>& stages_;
    State& state_;
    ForceField& force_field_;
    StepObserver& observer_;
    LoopPosition position_;
    Stopwatch watch_;
    Index step_;
};

}  // namespace

LoopSeconds run_stages(const std::vector<Stage>& stages, State& state, ForceField& force_field, StepObserver& observer,
                       const std::optional<LoopPosition>& from) {
    std::optional<TimeLoop> loop;
    try {
        if (!from) {
            observer.started(force_field.evaluate(state, Request::forces_and_energy));
        }
        loop.emplace(stages, state, force_field, observer, from.value_or(LoopPosition{}));
        if (!from) {
            loop->offer_checkpoint(true);
        }
        return loop->run();
    } catch (const PhysicsError& error) {
        throw PhysicsError(
            fmt::format("step {}{}: {}", loop ? loop->step() : state.step, loop ? loop->where() : "", error.what()));
    }
}

LoopSeconds run_stages(const Deck& deck, State& state, ForceField& force_field, StepObserver& observer,
                       const std::optional<LoopPosition>& from) {
    try {
        return run_stages(deck.stages, state, force_field, observer, from);
    } catch (const PhysicsError& error) {
        throw PhysicsError(error.what() + save_failure(deck, state));
    }
}

}  // namespace ljmd
