#pragma once

#include <functional>

#include "deck/deck.hpp"
#include "execution/ranks.hpp"
#include "ljmd/detail/engine/run_outputs.hpp"

namespace ljmd {

/// The outputs of a run that several ranks share. Rank 0 has them, and its clock and signals decide when a checkpoint
/// is written and the run is stopped; the others follow. Alone, it passes everything on.
class SharedOutputs : public RunOutputs {
  public:
    /// @param outputs  at rank 0; null elsewhere
    SharedOutputs(const RunPlan& plan, Ranks& ranks, RunOutputs* outputs)
        : plan_(plan), ranks_(ranks), outputs_(outputs) {}

    void stage_begins(const Stage& stage) override;
    using RunOutputs::row;
    void row(const ThermoRow& row) override;
    void errors(const std::vector<ErrorSoFar>& errors) override;
    [[nodiscard]] bool frame_is_due(const State& state) const override;
    void frame(const State& state, const std::optional<double>& angle) override;
    void step_done(Index step) override;
    [[nodiscard]] bool checkpoint_is_due(Index step, bool last_of_stage) override;
    /// @throws Interrupted at all ranks, if rank 0 is stopped
    void checkpoint(const State& state, const LoopPosition& position,
                    const std::function<void(Archive&)>& archive) override;

  private:
    const RunPlan& plan_;
    Ranks& ranks_;
    RunOutputs* outputs_;
};

}  // namespace ljmd
