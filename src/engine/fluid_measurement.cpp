#include "engine/fluid_measurement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "core/stopwatch.hpp"
#include "core/text.hpp"
#include "engine/mistakes/mistakes.hpp"
#include "engine/result_doubts.hpp"
#include "ljmd/core/errors.hpp"
#include "model/all_atoms.hpp"
#include "model/atoms_by_id.hpp"
#include "model/checksum.hpp"
#include "observables/interface/film.hpp"
#include "observables/response/response_functions.hpp"
#include "observables/transport/centre_frame.hpp"
#include "observables/transport/finite_size.hpp"

namespace ljmd {

namespace {

/// Steps between checks of the atoms' speeds; a check costs a hundredth of a step.
constexpr Index steps_between_looks = 10;

}  // namespace

FluidMeasurement::FluidMeasurement(const FluidSpec& spec, FluidSystem& fluid, RunOutputs& outputs,
                                   const std::vector<Observer*>& observers)
    : spec_(spec),
      fluid_(fluid),
      outputs_(outputs),
      sample_every_(spec.sample_every),
      averages_(fluid.state.total(), sampled_ensemble(spec.stages, spec.external != nullptr),
                spec.external && spec.external->has_energy(), sampled_baths(spec.stages, spec.sample_every)),
      analyses_(spec, fluid, observers),
      too_near_(spec.potential) {}

void FluidMeasurement::resume_at(const LoopPosition& position) {
    if (position.begun) {
        begin_to_watch(spec_.stages.at(position.stage));
    }
}

void FluidMeasurement::archive(Archive& a) {
    archive_presence(a, spec_.external.get());
    if (spec_.external) {
        a(external_differs_);
    }
    a(fluid_.state);
    fluid_.force_field.archive(a, fluid_.state);
    a.mark("averages");
    a(averages_, too_near_, until_, order_at_sampling_, first_, last_, drift_, step_error_, stages_, seconds_,
      force_before_, search_before_);
    if (watch_) {
        a(*watch_);
    }
    analyses_.archive(a);
}

void FluidMeasurement::require_begun(const LoopPosition& position) const {
    require_stages(stages_, spec_.stages, position);
}

bool FluidMeasurement::wants_checkpoint(bool last_of_stage) {
    return outputs_.checkpoint_is_due(fluid_.state.step, last_of_stage);
}

void FluidMeasurement::checkpoint(const LoopPosition& position) {
    if (watch_) {
        watch_->check_speeds(fluid_.state);  // a checkpoint after a blow-up would be useless
    }
    Stopwatch watch;
    outputs_.checkpoint(fluid_.state, position, [this](Archive& a) { archive(a); });
    seconds_.write += watch.lap();
}

void FluidMeasurement::begin_to_watch(const Stage& stage) {
    sampling_ = stage.sample;
    conserves_energy_ = conserves_energy(stage, spec_.external.get());
    watch_.emplace(stage.time_step, !stage.thermostat && conserves_energy_, fluid_.force_field.potential());
}

void FluidMeasurement::started(const Evaluation& evaluation) {
    const Thermodynamics values = thermodynamics(fluid_.state, evaluation, fluid_.tail);
    look_by_id(fluid_.state, [this] { outputs_.frame(fluid_.state, std::nullopt); });
    put_row(values);
    first_ = values;
    seconds_ = {};  // the time loop begins here: earlier time is not counted
    force_before_ = fluid_.force_field.seconds_summing();
    search_before_ = fluid_.force_field.search_statistics();
    if (total_steps(spec_.stages) == 0) {
        averages_.add(values);
        too_near_.sample(fluid_.state);
        sample(evaluation, true);
    }
}

/// Per atom; nothing if this stage has no conserved energy.
std::optional<double> FluidMeasurement::conserved_energy(const Thermodynamics& row) const {
    const State& state = fluid_.state;
    return conserves_energy_ ? std::optional(row.total_energy - state.heat() / static_cast<double>(state.total()))
                             : std::nullopt;
}

void FluidMeasurement::put_row(const Thermodynamics& values) {
    last_ = values;
    const ThermoRow row{fluid_.state.step, fluid_.state.time, values, conserved_energy(values), order()};
    Stopwatch watch;
    outputs_.row(row);
    seconds_.write += watch.lap();
}

void FluidMeasurement::sample(const Evaluation& evaluation, bool always) {
    external_differs_ = external_differs_ || fluid_.force_field.external_differs();
    analyses_.sample(evaluation, always || wants_energy(fluid_.state.step), always);
}

void FluidMeasurement::stage_begins(const Stage& stage) {
    outputs_.stage_begins(stage);
    const State& state = fluid_.state;
    if (stage.sample && stage.steps > 0 && !order_at_sampling_) {
        order_at_sampling_ = order();
    }
    begin_to_watch(stage);
    analyses_.stage_begins(stage);
    drift_ = {};
    step_error_ = {};
    stages_.push_back(begun_stage(stage, state, stage.thermostat.has_value()));
}

bool FluidMeasurement::wants_energy(Index step) const {
    return sample_every_.due(step) || (sampling_ && analyses_.want_energy(step));
}

bool FluidMeasurement::reads_velocities(Index step_of_stage) const {
    const State& state = fluid_.state;
    return step_of_stage % steps_between_looks == 0 || sample_every_.due(state.step) || outputs_.frame_is_due(state) ||
           (sampling_ && analyses_.are_due(state.step));
}

void FluidMeasurement::moved(Index step_of_stage) {
    if (step_of_stage % steps_between_looks == 0) {
        watch_->check_speeds(fluid_.state);
    }
}

void FluidMeasurement::step_done(const Stage& stage, const Evaluation& evaluation) {
    const State& state = fluid_.state;
    if (sample_every_.due(state.step)) {
        const Thermodynamics values = thermodynamics(state, evaluation, fluid_.tail);
        put_row(values);
        watch_->check_energy(values);
        if (const auto energy = conserved_energy(values)) {
            drift_.add(state.time, *energy);
        }
        if (stage.sample) {
            averages_.add(values);
            too_near_.sample(state);
            step_error_.add(state, stage.time_step);
        }
    }
    if (stage.sample) {
        sample(evaluation, false);
    }
    if (outputs_.frame_is_due(state)) {
        Stopwatch watch;
        look_by_id(state, [&] { outputs_.frame(state, std::nullopt); });
        seconds_.write += watch.lap();
    }
    outputs_.step_done(state.step);
}

bool FluidMeasurement::has_enough(const Stage& stage) {
    const Index step = fluid_.state.step;
    const bool is_last = step == stages_.back().first_step + stage.steps;
    return until_.reached(stage, averages_, sample_every_.due(step), is_last, outputs_);
}

void FluidMeasurement::stage_ends(const Stage& /*stage*/) {
    complete(stages_.back());
    watch_.reset();
}

void FluidMeasurement::complete(StageResult& stage) const {
    stage.last_step = fluid_.state.step;
    stage.energy_drift = conserves_energy_ ? drift_.slope() : std::nullopt;
    stage.time_step_error = step_error_.value();
    stage.checksum_at_end = checksum(fluid_.state);
}

PhaseSeconds FluidMeasurement::phases(const LoopSeconds& loop) const {
    const SearchStatistics& search = fluid_.force_field.search_statistics();
    PhaseSeconds seconds = seconds_;
    seconds.force = fluid_.force_field.seconds_summing() - force_before_;
    seconds.list = search.seconds_listing - search_before_.seconds_listing;
    seconds.sort = search.seconds_sorting - search_before_.seconds_sorting;
    seconds.integrate = loop.steps - seconds.force - seconds.list - seconds.sort;
    seconds.observe = loop.all - loop.steps - seconds.write;
    return seconds;
}

RunResult FluidMeasurement::result(const LoopSeconds& loop) const {
    const State& state = fluid_.state;
    const auto equation = equation_of_fluid(spec_);
    RunResult result{state.total(),
                     density(),
                     state.box().edges(),
                     averages_.averages(),
                     requested_temperature(spec_),
                     {},
                     equation ? std::optional(equation->name) : std::nullopt,
                     order_at_sampling_,
                     stages_,
                     {},
                     {},
                     fluid_.force_field.search_statistics(),
                     phases(loop),
                     first_,
                     last_};
    if (!result.stages.empty() && result.stages.back().checksum_at_end.empty()) {  // its last stage has not ended
        complete(result.stages.back());
    }
    if (averages_.samples() > 0) {
        result.at_requested = at_requested_temperature(spec_, density(), averages_);
    }
    if (stages_.size() == spec_.stages.size()) {
        until_.add_to(result, spec_.stages.back(), averages_);
    }
    analyses_.add_to(result);
    mark_slow_exchange(result.averages);
    withhold_slow_responses(result.averages);
    if (external_differs_) {
        withdraw_diffusion(result.averages, fmt::format("the external force '{}' differs between atoms: {}",
                                                        printable(spec_.external->name(), 64), no_frame_of_diffusion));
    }
    if (const auto infinite =
            spec_.external ? std::nullopt : diffusion_in_infinite_system(result.averages, state.box())) {
        result.averages.push_back(*infinite);
    }
    analyses_.add_observed_to(result);
    result.too_near = too_near_.remark();
    add_remarks(result, spec_);
    return result;
}

}  // namespace ljmd
