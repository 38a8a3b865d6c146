#include "ljmd/run/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "ljmd/core/errors.hpp"
#include "ljmd/core/schedule.hpp"
#include "ljmd/core/stopwatch.hpp"
#include "ljmd/core/text.hpp"
#include "ljmd/deck/deck_sense.hpp"
#include "ljmd/deck/sampled_run.hpp"
#include "ljmd/engine/stability.hpp"
#include "ljmd/model/checksum.hpp"
#include "ljmd/observables/statistics/linear_trend.hpp"
#include "ljmd/observables/time_step_error.hpp"
#include "ljmd/observables/transport/finite_size.hpp"
#include "ljmd/run/deck_stages.hpp"
#include "ljmd/run/results.hpp"
#include "ljmd/run/run_directory.hpp"
#include "ljmd/run/run_report.hpp"

namespace ljmd {

namespace {

/// With more than this of the crystal left, sampling measures neither crystal nor liquid.
constexpr double crystal_left = 0.1;

/// Steps between checks of the atoms' speeds; a check costs a hundredth of a step.
constexpr Index steps_between_looks = 10;

/// A run of a fluid: samples and writes while the time loop runs.
class FluidRun : private StepObserver {
  public:
    FluidRun(const Deck& deck, Simulation& simulation, RunListener& listener, const RunControl& control)
        : deck_(deck),
          simulation_(simulation),
          listener_(listener),
          thermo_every_(deck.thermo_every),
          checkpoints_(deck, control.interruption, control.resumed ? control.resumed->point.file.generation : 0,
                       control.has_begun),
          averages_(simulation.state.count(), sampled_ensemble(deck)),
          analysed_edges_(simulation.state.box().edges()) {
        std::optional<ResumedOutputs> outputs;
        if (control.resumed) {
            const ResumePoint& point = control.resumed->point;
            from_ = point.head.position;
            if (from_->begun) {
                begin_to_watch(deck.stages.at(from_->stage));
            }
            point.restore(deck, simulation.state, [this](Archive& a) { archive(a); });
            require_stages(stages_, deck, *from_);
            outputs.emplace(ResumedOutputs{point.head.outputs, control.resumed->earlier});
            check_outputs(deck, *outputs);
        }
        if (from_ && from_->begun) {
            listener.stage_begins(deck.stages.at(from_->stage));
        }
        // No file was changed until here.
        files_.emplace(deck, simulation.state, simulation.order.has_value(), outputs);
    }

    RunResult run() { return finish(run_stages(deck_, simulation_.state, simulation_.force_field, *this, from_)); }

  private:
    /// Everything that the rest of the run depends on, except files.
    void archive(Archive& a) {
        a(simulation_.state);
        simulation_.force_field.archive(a, simulation_.state);
        a.mark("averages");
        a(averages_, order_at_sampling_, first_, last_, drift_, step_error_, stages_, seconds_, force_before_,
          search_before_);
        if (watch_) {
            a(*watch_);
        }
        a.mark("analyses");
        for (const auto& analysis : simulation_.analyses) {
            analysis->archive(a);
        }
    }

    [[nodiscard]] bool wants_checkpoint(bool last_of_stage) override {
        return checkpoints_.due(simulation_.state.step, last_of_stage);
    }

    void checkpoint(const LoopPosition& position) override {
        if (watch_) {
            watch_->check_speeds(simulation_.state);  // a checkpoint after a blow-up would be useless
        }
        Stopwatch watch;
        const CommittedOutputs outputs = files_->commit();
        checkpoints_.write(simulation_.state, position, outputs, [this](Archive& a) { archive(a); });
        seconds_.write += watch.lap();
    }

    void begin_to_watch(const Stage& stage) {
        sampling_ = stage.sample;
        conserves_energy_ = conserves_energy(stage);
        watch_.emplace(stage.time_step, !stage.thermostat, simulation_.force_field.potential());
    }

    void started(const Evaluation& evaluation) override {
        const Thermodynamics row = thermodynamics_of(evaluation);
        files_->write_frame(simulation_.state);
        write_thermo(row);
        first_ = row;
        // The time loop begins here: earlier time is not counted.
        seconds_ = {};
        force_before_ = simulation_.force_field.seconds_summing();
        search_before_ = simulation_.force_field.search_statistics();
        if (deck_.total_steps() == 0) {
            averages_.add(row);
            sample_analyses(evaluation, true);
        }
    }

    [[nodiscard]] double density() const {
        return static_cast<double>(simulation_.state.count()) / simulation_.state.box().volume();
    }

    [[nodiscard]] Thermodynamics thermodynamics_of(const Evaluation& evaluation) const {
        return thermodynamics(simulation_.state, evaluation, simulation_.tail);
    }

    [[nodiscard]] std::optional<double> order() const {
        return simulation_.order ? std::optional((*simulation_.order)(simulation_.state)) : std::nullopt;
    }

    /// Per atom; nothing if this stage has no conserved energy.
    [[nodiscard]] std::optional<double> conserved_energy(const Thermodynamics& row) const {
        const State& state = simulation_.state;
        return conserves_energy_ ? std::optional(row.total_energy - state.heat() / static_cast<double>(state.count()))
                                 : std::nullopt;
    }

    void write_thermo(const Thermodynamics& row) {
        last_ = row;
        const std::optional<double> order_now = order();
        Stopwatch watch;
        files_->write_thermo(simulation_.state.step, simulation_.state.time, row, {conserved_energy(row), order_now});
        seconds_.write += watch.lap();
    }

    void sample_analyses(const Evaluation& evaluation, bool always) {
        for (const auto& analysis : simulation_.analyses) {
            if (always || analysis->due(simulation_.state.step)) {
                analysis->sample(simulation_.state, evaluation);
            }
        }
    }

    void stage_begins(const Stage& stage) override {
        listener_.stage_begins(stage);
        const State& state = simulation_.state;
        const bool thermostatted = stage.thermostat.has_value();
        if (stage.sample && stage.steps > 0 && !order_at_sampling_) {
            order_at_sampling_ = order();
        }
        begin_to_watch(stage);
        if (stage.sample && state.box().edges() != analysed_edges_) {
            adapt_analyses();
        }
        for (const auto& analysis : simulation_.analyses) {
            analysis->interrupt();
        }
        drift_ = {};
        step_error_ = {};
        stages_.push_back({stage.name,
                           stage.integrator.plugin.name,
                           state.step,
                           state.step,
                           stage.time_step,
                           stage.sample,
                           thermostatted,
                           stage.reverse,
                           std::nullopt,
                           checksum(state),
                           {}});
    }

    /// A barostat has changed the box since the analyses were made. They have no samples yet, see check_analysis.
    void adapt_analyses() {
        const State& state = simulation_.state;
        Diagnostics diagnostics;
        check_box(deck_.root, state.count(), state.box(), diagnostics);
        for (const Diagnostic& diagnostic : diagnostics.entries()) {
            if (diagnostic.severity == Severity::error) {
                throw PhysicsError(fmt::format("in the box that the barostat has made: {}", diagnostic.message));
            }
        }
        simulation_.analyses = make_analyses(deck_, simulation_);
        analysed_edges_ = state.box().edges();
    }

    [[nodiscard]] bool wants_energy(Index step) const override {
        return thermo_every_.due(step) || (sampling_ && energy_is_needed(step));
    }

    [[nodiscard]] bool energy_is_needed(Index step) const {
        return std::ranges::any_of(simulation_.analyses, [step](const auto& analysis) {
            return analysis->needs_energy() && analysis->due(step);
        });
    }

    void moved(Index step_of_stage) override {
        if (step_of_stage % steps_between_looks == 0) {
            watch_->check_speeds(simulation_.state);
        }
    }

    void step_done(const Stage& stage, const Evaluation& evaluation) override {
        const State& state = simulation_.state;
        if (thermo_every_.due(state.step)) {
            const Thermodynamics row = thermodynamics_of(evaluation);
            write_thermo(row);
            watch_->check_energy(row);
            if (const auto energy = conserved_energy(row)) {
                drift_.add(state.time, *energy);
            }
            if (stage.sample) {
                averages_.add(row);
                step_error_.add(state, stage.time_step);
            }
        }
        if (stage.sample) {
            sample_analyses(evaluation, false);
        }
        if (files_->frame_is_due(state)) {
            Stopwatch watch;
            files_->write_frame(state);
            seconds_.write += watch.lap();
        }
        listener_.step_done(state.step);
    }

    void stage_ends(const Stage&) override {
        StageResult& stage = stages_.back();
        stage.last_step = simulation_.state.step;
        stage.energy_drift = conserves_energy_ ? drift_.slope() : std::nullopt;
        stage.time_step_error = step_error_.value();
        stage.checksum_at_end = checksum(simulation_.state);
    }

    [[nodiscard]] PhaseSeconds phases(const LoopSeconds& loop) const {
        const SearchStatistics& search = simulation_.force_field.search_statistics();
        PhaseSeconds seconds = seconds_;
        seconds.force = simulation_.force_field.seconds_summing() - force_before_;
        seconds.list = search.seconds_listing - search_before_.seconds_listing;
        seconds.sort = search.seconds_sorting - search_before_.seconds_sorting;
        seconds.integrate = loop.steps - seconds.force - seconds.list - seconds.sort;
        seconds.observe = loop.all - loop.steps - seconds.write;
        return seconds;
    }

    RunResult finish(const LoopSeconds& loop) {
        const State& state = simulation_.state;
        RunResult result{state.count(),
                         density(),
                         state.box().edges(),
                         averages_.averages(),
                         asked_temperature(deck_),
                         {},
                         order_at_sampling_,
                         stages_,
                         {},
                         {},
                         simulation_.force_field.search_statistics(),
                         phases(loop),
                         first_,
                         last_};
        judge_stages(result);
        compare_with_asked_temperature(result);
        for (const auto& analysis : simulation_.analyses) {
            std::ranges::move(analysis->tables(), std::back_inserter(result.tables));
            std::ranges::move(analysis->observables(), std::back_inserter(result.averages));
        }
        if (const auto infinite = diffusion_in_infinite_system(result.averages, state.box())) {
            result.averages.push_back(*infinite);
        }
        result.warnings = doubts(result);
        for (const std::string& warning : result.warnings) {
            listener_.warning(warning);
        }
        files_->finish(state, result);
        return result;
    }

    static void judge_stages(RunResult& result) {
        const auto kinetic = std::ranges::find(result.averages, "kinetic_energy", &ObservableAverage::name);
        for (StageResult& stage : result.stages) {
            if (stage.sampled && kinetic != result.averages.end() && kinetic->estimate) {
                stage.drift_remark = drift_remark(stage, kinetic->estimate->mean);
            }
            stage.time_step_remark = time_step_remark(stage);
        }
    }

    void compare_with_asked_temperature(RunResult& result) const {
        for (ObservableAverage& average : result.averages) {
            if (average.name == "temperature" && average.estimate) {
                average.remark = temperature_remark(deck_, average.estimate);
            }
        }
        if (averages_.samples() > 0) {
            result.at_asked = at_asked_temperature(deck_, density(), averages_);
        }
    }

    /// Warnings about the results.
    [[nodiscard]] std::vector<std::string> doubts(const RunResult& result) const {
        std::vector<std::string> doubts;
        if (deck_.total_steps() == 0) {
            return doubts;
        }
        if (result.averages.empty()) {
            doubts.emplace_back("no sample was taken: set sample = true in a stage longer than the thermo interval");
        }
        if (result.order_at_sampling && *result.order_at_sampling > crystal_left) {
            doubts.push_back(
                fmt::format("sampling began with {:.0f} % of the crystal left (translational order {:.3f}): "
                            "equilibrate longer, or melt above the target temperature first",
                            100.0 * *result.order_at_sampling, *result.order_at_sampling));
        }
        if (const Index late = result.search.late_rebuilds; late > 0) {
            doubts.push_back(fmt::format(
                "{} of {} neighbor lists were kept too long: an atom had moved by more than half the skin, "
                "and pairs within the cutoff may have been missed. Take a larger skin or a smaller `every`, "
                "or leave `every` out",
                late, result.search.rebuilds));
        }
        for (const StageResult& stage : result.stages) {
            if (!stage.drift_remark.empty()) {
                doubts.push_back(
                    fmt::format("the energy drifts in stage {}: {}", in_quotes(stage.name), stage.drift_remark));
            }
            if (!stage.time_step_remark.empty()) {
                doubts.push_back(
                    fmt::format("the time step of stage '{}' is too long: {}", stage.name, stage.time_step_remark));
            }
        }
        if (const std::string unsure = unsure_of(result.averages); !unsure.empty()) {
            doubts.push_back(fmt::format("the run is too short for the error bars of {}: they are guesses", unsure));
        }
        return doubts;
    }

    const Deck& deck_;
    Simulation& simulation_;
    RunListener& listener_;
    Every thermo_every_;
    RunCheckpoints checkpoints_;
    std::optional<LoopPosition> from_;   ///< of a resumed run
    std::optional<RunDirectory> files_;  ///< opened when it is known that the run can begin
    RunAverages averages_;
    std::optional<double> order_at_sampling_;
    std::optional<StabilityWatch> watch_;  ///< for the current stage
    bool sampling_ = false;                ///< the current stage is sampled
    bool conserves_energy_ = true;         ///< the current stage has a conserved energy
    Vec3 analysed_edges_;                  ///< edges of the box that the analyses were made for
    Thermodynamics first_;
    Thermodynamics last_;
    LinearTrend drift_;         ///< of the conserved energy per atom in the current stage
    TimeStepError step_error_;  ///< in the current stage
    std::vector<StageResult> stages_;
    PhaseSeconds seconds_;            ///< wall time measured here
    double force_before_ = 0.0;       ///< seconds spent by the force field
    SearchStatistics search_before_;  ///< and by its search before the time loop
};

}  // namespace

void require_stages(const std::vector<StageResult>& results, const Deck& deck, const LoopPosition& position) {
    bool same = results.size() == position.stage + (position.begun ? 1 : 0);
    for (std::size_t k = 0; same && k < results.size(); ++k) {
        same = results[k].name == deck.stages[k].name && results[k].integrator == deck.stages[k].integrator.plugin.name;
    }
    if (!same) {
        throw CheckpointError("the checkpoint has results of other stages than the deck");
    }
}

RunResult run_deck(const Deck& deck, Simulation& simulation, RunListener& listener, const RunControl& control) {
    return FluidRun(deck, simulation, listener, control).run();
}

}  // namespace ljmd
