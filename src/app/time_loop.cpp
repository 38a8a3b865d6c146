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

/// @param step  of the run; told as it grows, for messages
/// @return seconds spent on steps
double run_stage(const Stage& stage, State& state, ForceField& force_field, StepObserver& observer, Index& step) {
    const Integrator integrator(find_integrator(stage.integrator), stage.time_step, stage.section);
    integrator.prepare(state, force_field);
    observer.stage_begins(stage);
    const std::unique_ptr<Thermostat> thermostat = thermostat_of(stage);
    if (stage.reverse) {
        integrator.reverse(state, force_field);
    }
    const double first_time = state.time;
    double seconds = 0.0;
    for (Index n = 1; n <= stage.steps; ++n) {
        ++step;
        Stopwatch watch;
        const Evaluation evaluation =
            integrator.step(state, force_field, {.energy = observer.wants_energy(step), .order_independent = false});
        seconds += watch.lap();
        state.step = step;
        state.time = first_time + static_cast<double>(n) * stage.time_step;
        observer.moved(n);
        if (thermostat) {
            thermostat->apply(state, n);
        }
        observer.step_done(stage, evaluation);
    }
    observer.stage_ends(stage);
    return seconds;
}

}  // namespace

LoopSeconds run_stages(const std::vector<Stage>& stages, State& state, ForceField& force_field,
                       StepObserver& observer) {
    Index step = state.step;
    std::string where;
    try {
        observer.started(force_field.evaluate(state, Request::forces_and_energy));
        LoopSeconds seconds;
        Stopwatch watch;
        for (const Stage& stage : stages) {
            where = fmt::format(" (stage '{}')", stage.name);
            seconds.steps += run_stage(stage, state, force_field, observer, step);
        }
        seconds.all = watch.lap();
        return seconds;
    } catch (const PhysicsError& error) {
        throw PhysicsError(fmt::format("step {}{}: {}", step, where, error.what()));
    }
}

LoopSeconds run_stages(const Deck& deck, State& state, ForceField& force_field, StepObserver& observer) {
    try {
        return run_stages(deck.stages, state, force_field, observer);
    } catch (const PhysicsError& error) {
        throw PhysicsError(error.what() + save_failure(deck, state));
    }
}

}  // namespace ljmd
