#pragma once

#include <optional>
#include <vector>

#include "core/schedule.hpp"
#include "engine/errors_to_reach.hpp"
#include "engine/fluid_system.hpp"
#include "engine/run_measurement.hpp"
#include "engine/sampled_analyses.hpp"
#include "engine/stability.hpp"
#include "ljmd/detail/engine/run_outputs.hpp"
#include "ljmd/detail/engine/time_loop.hpp"
#include "ljmd/detail/observables/statistics/run_averages.hpp"
#include "ljmd/engine/fluid_spec.hpp"
#include "ljmd/engine/observer.hpp"
#include "ljmd/engine/run_result.hpp"
#include "observables/pairs_too_near.hpp"
#include "observables/statistics/linear_trend.hpp"
#include "observables/time_step_error.hpp"

namespace ljmd {

/// Measures a fluid while the time loop runs: samples of the thermodynamics, analyses, observers, stability, and the
/// results of the stages. Neither decks nor files are known here, see RunOutputs.
class FluidMeasurement : public RunMeasurement {
  public:
    /// All must live as long as this. @param observers  are called in the sampled stages, after the analyses
    FluidMeasurement(const FluidSpec& spec, FluidSystem& fluid, RunOutputs& outputs,
                     const std::vector<Observer*>& observers = {});

    void resume_at(const LoopPosition& position) override;
    void archive(Archive& a) override;
    void require_begun(const LoopPosition& position) const override;

    /// The analyses and observers of the run. Observers can be added.
    [[nodiscard]] SampledAnalyses& analyses() { return analyses_; }

    /// The results so far. @param loop  wall time of the time loop
    [[nodiscard]] RunResult result(const LoopSeconds& loop) const;

    [[nodiscard]] LoopParty party() { return {*this, this}; }

    void started(const Evaluation& evaluation) override;
    void stage_begins(const Stage& stage) override;
    void energy_set(const EnergyStart& start) override { stages_.back().energy_start = start; }
    [[nodiscard]] bool wants_energy(Index step) const override;
    [[nodiscard]] bool reads_velocities(Index step_of_stage) const override;
    void moved(Index step_of_stage) override;
    void step_done(const Stage& stage, const Evaluation& evaluation) override;
    [[nodiscard]] bool has_enough(const Stage& stage) override;
    [[nodiscard]] bool wants_checkpoint(bool last_of_stage) override;
    void checkpoint(const LoopPosition& position) override;
    void stage_ends(const Stage& stage) override;

  private:
    void begin_to_watch(const Stage& stage);
    void complete(StageResult& stage) const;
    void put_row(const Thermodynamics& values);
    void sample(const Evaluation& evaluation, bool always);
    [[nodiscard]] double density() const {
        return static_cast<double>(fluid_.state.total()) / fluid_.state.box().volume();
    }
    [[nodiscard]] std::optional<double> order() const {
        return fluid_.order ? std::optional((*fluid_.order)(fluid_.state)) : std::nullopt;
    }
    [[nodiscard]] std::optional<double> conserved_energy(const Thermodynamics& row) const;
    [[nodiscard]] PhaseSeconds phases(const LoopSeconds& loop) const;

    const FluidSpec& spec_;
    FluidSystem& fluid_;
    RunOutputs& outputs_;
    Every sample_every_;
    RunAverages averages_;
    SampledAnalyses analyses_;
    ErrorsToReach until_;
    PairsTooNear too_near_;
    std::optional<double> order_at_sampling_;
    std::optional<StabilityWatch> watch_;  ///< for the current stage
    bool sampling_ = false;                ///< the current stage is sampled
    bool conserves_energy_ = true;         ///< the current stage has a conserved energy
    bool external_differs_ = false;        ///< the external force did between atoms, in sampled stages
    Thermodynamics first_;
    Thermodynamics last_;
    LinearTrend drift_;         ///< of the conserved energy per atom in the current stage
    TimeStepError step_error_;  ///< in the current stage
    std::vector<StageResult> stages_;
    PhaseSeconds seconds_;            ///< wall time measured here
    double force_before_ = 0.0;       ///< seconds spent by the force field
    SearchStatistics search_before_;  ///< and by its search before the time loop
};

}  // namespace ljmd
