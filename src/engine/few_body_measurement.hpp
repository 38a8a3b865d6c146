#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/schedule.hpp"
#include "engine/few_body_system.hpp"
#include "engine/run_measurement.hpp"
#include "ljmd/detail/engine/few_body_result.hpp"
#include "ljmd/detail/engine/run_outputs.hpp"
#include "ljmd/detail/observables/few_body/few_body.hpp"
#include "ljmd/engine/run_result.hpp"
#include "observables/statistics/linear_trend.hpp"

namespace ljmd {

/// Measures a few-body system while the time loop runs: totals, analyses, stability, and the results of the stages.
/// Neither decks nor files are known here, see RunOutputs.
class FewBodyMeasurement : public RunMeasurement, public MomentObserver {
  public:
    /// All must live as long as this. @param sample_every  steps between samples of the totals
    FewBodyMeasurement(const std::vector<Stage>& stages, Index sample_every, FewBodySystem& system,
                       RunOutputs& outputs);

    void resume_at(const LoopPosition& /*position*/) override {}
    void archive(Archive& a) override;
    void require_begun(const LoopPosition& position) const override;

    /// Add a row for the end of the run if it has none, because the results report it. It comes after the last
    /// checkpoint: so a run that is extended does not keep a row that one long run would not have.
    /// @throws PhysicsError as the time loop
    void record_end();

    /// @param loop  wall time of the finished time loop
    [[nodiscard]] FewBodyResult result(const LoopSeconds& loop) const;

    [[nodiscard]] LoopParty party() { return {*this, this, this}; }

    void started(const Evaluation& evaluation) override;
    void stage_begins(const Stage& stage) override;
    [[nodiscard]] bool wants_energy(Index step) const override { return sample_every_.due(step); }
    [[nodiscard]] bool looks_within_steps(const Stage& stage) const override;
    void within_step(const Stage& stage, const State& moment) override;
    void step_done(const Stage& stage, const Evaluation& evaluation) override;
    [[nodiscard]] bool wants_checkpoint(bool last_of_stage) override;
    void checkpoint(const LoopPosition& position) override;
    void stage_ends(const Stage& stage) override;

  private:
    void require_finite() const;
    void add_angle(const State& state);
    [[nodiscard]] std::optional<double> angle() const;
    void sample(const State& state);
    void record(const Evaluation& evaluation);

    const std::vector<Stage>& all_stages_;
    Every sample_every_;
    FewBodySystem& system_;
    RunOutputs& outputs_;
    PolarAngleQuadrature quadrature_;
    std::optional<PolarAngle> angle_;
    double sense_of_angle_ = 1.0;  ///< -1 after a reversal
    bool sampling_ = false;        ///< a sampled stage has begun
    Index rows_ = 0;
    std::vector<FewBodyHistory> histories_;
    LinearTrend drift_;  ///< of the total energy in the current stage
    std::vector<StageResult> stages_;
};

}  // namespace ljmd
