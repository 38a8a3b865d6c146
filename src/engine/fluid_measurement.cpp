#include "engine/fluid_measurement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "core/stopwatch.hpp"
#include "core/text.hpp"
#include "engine/mistakes.hpp"
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

/// The errors that a stage is to reach are shown each time the samples have grown by this share.
constexpr Index shown_share = 64;

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
      too_near_(spec.potential),
      analysed_edges_(fluid.state.box().edges()) {
    for (Observer* observer : observers) {
        add(*observer);
    }
}

void FluidMeasurement::add(Observer& observer) {
    if (std::ranges::find(observers_, &observer) != observers_.end()) {
        throw InputError("this observer measures already: it would see everything twice");
    }
    observers_.push_back(&observer);
}

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
    a(averages_, too_near_, errors_reached_, order_at_sampling_, first_, last_, drift_, step_error_, stages_, seconds_,
      force_before_, search_before_);
    if (watch_) {
        a(*watch_);
    }
    a.mark("analyses");
    for (const auto& analysis : fluid_.analyses) {
        analysis->archive(a);
    }
    std::size_t observers = observers_.size();
    a(observers);
    if (observers != observers_.size()) {
        throw CheckpointError(
            fmt::format("the checkpoint has {} observers of the program that wrote it, and {} are there: it is resumed "
                        "by that program, with the same observers",
                        observers, observers_.size()));
    }
    for (Observer* observer : observers_) {
        observer->archive(a);
    }
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
    const Index step = fluid_.state.step;
    const auto is_wanted = [=](const auto& each) { return always || each->due(step); };
    const auto is_needed = [=](const Observer* each) { return always || each->needs(step); };
    if (std::ranges::none_of(fluid_.analyses, is_wanted) && std::ranges::none_of(observers_, is_needed)) {
        return;
    }
    look_at_all_atoms(fluid_.state, [&](const State& state) {
        for (const auto& analysis : fluid_.analyses) {
            if (is_wanted(analysis)) {
                analysis->sample(state, evaluation);
            }
        }
        const bool known = always || wants_energy(step);
        const Snapshot snapshot(state, fluid_.tail, known ? std::optional(evaluation) : std::nullopt);
        for (Observer* observer : observers_) {
            if (is_needed(observer)) {
                observer->sample(snapshot);
            }
        }
    });
}

void FluidMeasurement::stage_begins(const Stage& stage) {
    outputs_.stage_begins(stage);
    const State& state = fluid_.state;
    if (stage.sample && stage.steps > 0 && !order_at_sampling_) {
        order_at_sampling_ = order();
    }
    begin_to_watch(stage);
    const bool unused = std::ranges::all_of(fluid_.analyses, [](const auto& each) { return each->samples() == 0; });
    if (stage.sample && unused && state.box().edges() != analysed_edges_) {
        adapt_analyses();
    }
    for (const auto& analysis : fluid_.analyses) {
        analysis->interrupt();
    }
    for (Observer* observer : observers_) {
        observer->interrupt();
    }
    drift_ = {};
    step_error_ = {};
    stages_.push_back(begun_stage(stage, state, stage.thermostat.has_value()));
}

/// A barostat has changed the box since the analyses were made, which have no samples yet. Those that have some do not
/// depend on the box: with others no stage with a barostat may come after the first sampled one.
void FluidMeasurement::adapt_analyses() {
    const State& state = fluid_.state;
    const std::vector<Mistake> wrong = box_mistakes(spec_, state.total(), state.box());
    if (!wrong.empty()) {
        throw PhysicsError(fmt::format("in the box that the barostat has made: {}", in_words(wrong.front())));
    }
    fluid_.analyses = make_analyses(spec_, state);
    analysed_edges_ = state.box().edges();
}

bool FluidMeasurement::wants_energy(Index step) const {
    if (sample_every_.due(step)) {
        return true;
    }
    return sampling_ && (std::ranges::any_of(fluid_.analyses,
                                             [step](const auto& analysis) {
                                                 return analysis->needs_energy() && analysis->due(step);
                                             }) ||
                         std::ranges::any_of(observers_, [step](const Observer* observer) {
                             return observer->needs_energy() && observer->needs(step);
                         }));
}

bool FluidMeasurement::reads_velocities(Index step_of_stage) const {
    const State& state = fluid_.state;
    if (step_of_stage % steps_between_looks == 0 || sample_every_.due(state.step) || outputs_.frame_is_due(state)) {
        return true;
    }
    const auto due = [&state](const auto& analysis) { return analysis->due(state.step); };
    const auto needs = [&state](const Observer* observer) { return observer->needs(state.step); };
    return sampling_ && (std::ranges::any_of(fluid_.analyses, due) || std::ranges::any_of(observers_, needs));
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

std::vector<ErrorSoFar> FluidMeasurement::errors_of(const Stage& stage) const {
    std::vector<ErrorSoFar> errors;
    errors.reserve(stage.until.size());
    const std::vector<ObservableAverage> averages = averages_.averages();
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const WantedError& wanted : stage.until) {
        const auto found = std::ranges::find(averages, wanted.observable, &ObservableAverage::name);
        if (found == averages.end() || !found->estimate) {
            errors.push_back({wanted, nan, nan, false});
        } else {
            const Estimate estimate = stopped_estimate(*found->estimate);
            errors.push_back(
                {wanted, estimate.standard_error, estimate.independent_samples, is_reached(estimate, wanted.error)});
        }
    }
    return errors;
}

/// The last step of a stage is looked at, too: its number was chosen before.
bool FluidMeasurement::has_enough(const Stage& stage) {
    if (stage.until.empty() || errors_reached_) {
        return false;
    }
    const Index samples = averages_.samples();
    const bool is_last = fluid_.state.step == stages_.back().first_step + stage.steps;
    const bool look = is_last || (sample_every_.due(fluid_.state.step) && is_look(samples));
    const bool show = sample_every_.due(fluid_.state.step) && samples % std::max<Index>(1, samples / shown_share) == 0;
    if (!look && !show) {
        return false;
    }
    const std::vector<ErrorSoFar> errors = errors_of(stage);
    outputs_.errors(errors);
    errors_reached_ = look && std::ranges::all_of(errors, &ErrorSoFar::reached);
    return errors_reached_;
}

/// The errors that decided the length are known less well than errors of a length that was chosen before, see
/// stopped_estimate().
void FluidMeasurement::widen_errors(RunResult& result) const {
    const Stage& stage = spec_.stages.back();
    if (stage.until.empty() || stages_.size() < spec_.stages.size()) {
        return;
    }
    result.stages.back().until = {errors_of(stage), stage.steps, errors_reached_};
    widen_wanted(result.averages, stage.until);
    if (result.at_requested) {
        widen_wanted(result.at_requested->observables, stage.until);
    }
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
    widen_errors(result);
    for (const auto& analysis : fluid_.analyses) {
        std::ranges::move(analysis->tables(), std::back_inserter(result.tables));
        std::ranges::move(analysis->observables(), std::back_inserter(result.averages));
    }
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
    for (const Observer* observer : observers_) {
        if (auto average = observer->average()) {
            average->own = true;
            result.averages.push_back(std::move(*average));
        }
    }
    result.too_near = too_near_.remark();
    add_remarks(result, spec_);
    return result;
}

void widen_wanted(std::vector<ObservableAverage>& averages, const std::vector<WantedError>& wanted) {
    for (ObservableAverage& average : averages) {
        if (average.estimate && std::ranges::find(wanted, average.name, &WantedError::observable) != wanted.end()) {
            average.estimate = stopped_estimate(*average.estimate);
        }
    }
}

}  // namespace ljmd
