#include "ljmd/run/few_body_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ljmd/core/errors.hpp"
#include "ljmd/core/schedule.hpp"
#include "ljmd/model/checksum.hpp"
#include "ljmd/model/velocities.hpp"
#include "ljmd/observables/few_body/few_body.hpp"
#include "ljmd/observables/statistics/linear_trend.hpp"
#include "ljmd/run/deck_stages.hpp"
#include "ljmd/run/few_body_directory.hpp"

namespace ljmd {

namespace {

FewBodyTotals totals_of(const State& state, double potential_energy) {
    const double kinetic = kinetic_energy(state);
    return {potential_energy, kinetic, potential_energy + kinetic, total_momentum(state), angular_momentum(state)};
}

std::vector<std::pair<std::string, double>> named(const FewBodyTotals& totals, int dimensions) {
    std::vector<std::pair<std::string, double>> values{{"potential_energy", totals.potential_energy},
                                                       {"kinetic_energy", totals.kinetic_energy},
                                                       {"total_energy", totals.total_energy}};
    for (int a = 0; a < dimensions; ++a) {
        values.emplace_back(fmt::format("momentum_{}", "xyz"[a]), totals.momentum[a]);
    }
    for (int a = dimensions == 2 ? 2 : 0; a < 3 && dimensions >= 2; ++a) {
        values.emplace_back(fmt::format("angular_momentum_{}", "xyz"[a]), totals.angular_momentum[a]);
    }
    return values;
}

/// A run of a few bodies: samples and writes while the time loop runs.
class FewBodyRun : private StepObserver {
  public:
    FewBodyRun(const Deck& deck, FewBodySystem& system, RunListener& listener, const RunControl& control)
        : deck_(deck),
          system_(system),
          listener_(listener),
          thermo_every_(deck.thermo_every),
          checkpoints_(deck, control.interruption, control.resumed ? control.resumed->point.file.generation : 0,
                       control.has_begun) {
        std::optional<ResumedOutputs> outputs;
        if (control.resumed) {
            const ResumePoint& point = control.resumed->point;
            from_ = point.head.position;
            point.restore(deck, system.state, [this](Archive& a) { archive(a); });
            require_stages(stages_, deck, *from_);
            require_sampled();
            outputs.emplace(ResumedOutputs{point.head.outputs, control.resumed->earlier});
            check_outputs(deck, *outputs);
        }
        if (from_ && from_->begun) {
            listener.stage_begins(deck.stages.at(from_->stage));
        }
        // No file was changed until here.
        files_.emplace(deck, system, outputs);
    }

    FewBodyResult run() {
        const LoopSeconds seconds = run_stages(deck_, system_.state, *system_.force_field, *this, from_);
        record_end();
        return finish(seconds);
    }

  private:
    /// Everything that the rest of the run depends on, except files.
    void archive(Archive& a) {
        a(system_.state);
        system_.force_field->archive(a, system_.state);
        a.mark("averages");
        a(quadrature_, angle_, sense_of_angle_, sampling_, rows_, histories_, drift_, stages_);
        a.mark("analyses");
        for (const auto& [name, analysis] : system_.analyses) {
            analysis->archive(a, system_.state);
        }
    }

    /// @throws CheckpointError unless the samples match the stages that have begun
    void require_sampled() const {
        const auto begun = deck_.stages.begin();
        const auto values = named(totals_of(system_.state, 0.0), system_.dimensions);
        const bool wanted =
            std::any_of(begun, begun + std::ssize(stages_), [](const Stage& stage) { return stage.sample; });
        const bool same =
            sampling_ == wanted &&
            std::equal(histories_.begin(), histories_.end(), values.begin(), values.end(),
                       [](const FewBodyHistory& history, const auto& value) { return history.name == value.first; });
        if (!same || rows_ < 0 || rows_ > system_.state.step + 1) {
            throw CheckpointError("the checkpoint has samples of other stages than the deck");
        }
    }

    [[nodiscard]] bool wants_checkpoint(bool last_of_stage) override {
        return checkpoints_.due(system_.state.step, last_of_stage);
    }

    void checkpoint(const LoopPosition& position) override {
        require_finite();  // a checkpoint after a blow-up would be useless
        const CommittedOutputs outputs = files_->commit();
        checkpoints_.write(system_.state, position, outputs, [this](Archive& a) { archive(a); });
    }

    void started(const Evaluation& evaluation) override {
        add_angle(system_.state);
        record(evaluation);
        files_->write_frame(system_.state, angle_);
    }

    void stage_begins(const Stage& stage) override {
        listener_.stage_begins(stage);
        const State& state = system_.state;
        if (stage.sample && !sampling_) {  // sampled stages are contiguous, see check_few_body_sense()
            sampling_ = true;
            sample_analyses(state);
        }
        if (stage.reverse) {
            sense_of_angle_ = -sense_of_angle_;  // the velocities are reversed after this
            if (angle_) {
                angle_ = quadrature_.turn_round();
            }
        }
        drift_ = {};
        stages_.push_back({stage.name,
                           stage.integrator.plugin.name,
                           state.step,
                           state.step,
                           stage.time_step,
                           stage.sample,
                           false,
                           stage.reverse,
                           std::nullopt,
                           checksum(state),
                           {}});
    }

    [[nodiscard]] bool wants_energy(Index step) const override { return thermo_every_.due(step); }

    [[nodiscard]] bool looks_within_steps(const Stage& stage) const override {
        return system_.force.plugin.has_polar_angle || (stage.sample && !system_.analyses.empty());
    }

    void within_step(const Stage& stage, const State& moment) override {
        add_angle(moment);
        if (stage.sample) {
            sample_analyses(moment);
        }
    }

    void moved(Index) override {}

    void step_done(const Stage& stage, const Evaluation& evaluation) override {
        const State& state = system_.state;
        add_angle(state);
        if (wants_energy(state.step)) {
            record(evaluation);
        }
        if (stage.sample) {
            sample_analyses(state);
        }
        if (deck_.trajectory && state.step % deck_.trajectory->every == 0) {
            files_->write_frame(state, angle_);
        }
        listener_.step_done(state.step);
    }

    void stage_ends(const Stage&) override {
        StageResult& stage = stages_.back();
        stage.last_step = system_.state.step;
        stage.energy_drift = drift_.slope();
        stage.checksum_at_end = checksum(system_.state);
    }

    /// Add a row for the end, because the results report it. It comes after the last checkpoint: so a run that is
    /// extended does not keep a row that one long run would not have.
    void record_end() {
        State& state = system_.state;
        if (thermo_every_.due(state.step)) {
            return;
        }
        try {
            record(system_.force_field->evaluate(state, Request::forces_and_energy));
        } catch (const PhysicsError& error) {
            throw PhysicsError(fmt::format("step {}: {}{}", state.step, error.what(), save_failure(deck_, state)));
        }
        stages_.back().energy_drift = drift_.slope();
    }

    /// @throws PhysicsError when a body has a position or velocity that is not finite
    void require_finite() const {
        const State& state = system_.state;
        for (Index i = 0; i < state.count(); ++i) {
            if (!state.positions().col(i).allFinite() || !std::isfinite(state.velocities().col(i).squaredNorm())) {
                throw PhysicsError(
                    fmt::format("body {} was pushed out of the range of numbers: the run has blown up. Is the time "
                                "step too large, or do bodies come too close?",
                                i + 1));
            }
        }
    }

    void add_angle(const State& state) {
        if (system_.force.plugin.has_polar_angle) {
            const auto [rate, slope] =
                system_.force.options->angular_velocity(state.positions()(0, 0), state.velocities()(0, 0));
            angle_ = quadrature_.add(state.time, sense_of_angle_ * rate, sense_of_angle_ * slope);
        }
    }

    void sample_analyses(const State& state) {
        for (const auto& [name, analysis] : system_.analyses) {
            analysis->sample({state, angle_});
        }
    }

    void record(const Evaluation& evaluation) {
        const State& state = system_.state;
        require_finite();
        const FewBodyTotals totals = totals_of(state, evaluation.potential_energy);
        if (!std::isfinite(totals.total_energy)) {
            throw PhysicsError(
                fmt::format("the total energy is {} now: the run has blown up. Is the time step too large, or do "
                            "bodies come too close?",
                            totals.total_energy));
        }
        files_->write_thermo(state, totals);
        drift_.add(state.time, totals.total_energy);
        ++rows_;
        const auto values = named(totals, system_.dimensions);
        if (histories_.empty()) {
            for (const auto& [name, value] : values) {
                histories_.push_back({name, value, value, 0.0, 0.0});
            }
        }
        for (std::size_t k = 0; k < values.size(); ++k) {
            FewBodyHistory& history = histories_[k];
            history.at_end = values[k].second;
            history.mean += (values[k].second - history.mean) / static_cast<double>(rows_);
            history.largest_deviation =
                std::max(history.largest_deviation, std::abs(values[k].second - history.at_start));
        }
    }

    FewBodyResult finish(const LoopSeconds& seconds) {
        FewBodyResult result{
            system_.state.count(), system_.dimensions, system_.force.plugin.name, histories_, stages_, {}, seconds.all};
        std::vector<DataTable> tables;
        for (const auto& [name, analysis] : system_.analyses) {
            result.findings.emplace_back(name, analysis->findings());
            if (const auto table = analysis->table()) {
                tables.push_back(*table);
            }
        }
        files_->finish(system_.state, result, tables);
        return result;
    }

    const Deck& deck_;
    FewBodySystem& system_;
    RunListener& listener_;
    Every thermo_every_;
    RunCheckpoints checkpoints_;
    std::optional<LoopPosition> from_;       ///< of a resumed run
    std::optional<FewBodyDirectory> files_;  ///< opened when it is known that the run can begin
    PolarAngleQuadrature quadrature_;
    std::optional<PolarAngle> angle_;
    double sense_of_angle_ = 1.0;  ///< -1 after a reversal
    bool sampling_ = false;        ///< a sampled stage has begun
    Index rows_ = 0;
    std::vector<FewBodyHistory> histories_;
    LinearTrend drift_;  ///< of the total energy in the current stage
    std::vector<StageResult> stages_;
};

}  // namespace

FewBodyResult run_few_body(const Deck& deck, FewBodySystem& system, RunListener& listener, const RunControl& control) {
    return FewBodyRun(deck, system, listener, control).run();
}

}  // namespace ljmd
