#pragma once

#include <optional>

#include "engine/run_measurement.hpp"
#include "ljmd/detail/engine/run_outputs.hpp"
#include "run/run.hpp"
#include "run/run_checkpoints.hpp"
#include "run/run_directory.hpp"

namespace ljmd {

/// Bring a run back to the checkpoint that it is resumed from, if it is. Collective where ranks share it.
/// @return the position to resume the time loop from  @throws CheckpointError
[[nodiscard]] std::optional<LoopPosition> restored(const RunPlan& plan, const std::optional<Continuation>& continuation,
                                                   RunMeasurement& measurement, const State& state);

/// The outputs of a run with a directory: its files, its checkpoints, and the listener.
class DirectoryOutputs : public RunOutputs {
  public:
    DirectoryOutputs(const RunPlan& plan, RunListener& listener, const RunControl& control);

    /// Open the files. Nothing was changed before.
    /// @param system  a FluidSystem or FewBodySystem that was restored, see restored()
    /// @param from    what restored() has returned  @throws FileError
    template <class System>
    void begin(const System& system, const std::optional<LoopPosition>& from) {
        if (from) {
            check_outputs(plan_, *control_.continuation);
            if (from->begun) {
                listener_.stage_begins(plan_.stages().at(from->stage));
            }
        }
        files_.emplace(plan_, system, control_.continuation);
    }

    [[nodiscard]] RunDirectory& files() { return *files_; }

    void stage_begins(const Stage& stage) override { listener_.stage_begins(stage); }
    void row(const ThermoRow& row) override {
        files_->write(row);
        listener_.sampled(row);
    }
    void row(const FewBodyRow& row) override {
        files_->write(row);
        listener_.sampled(row);
    }
    void errors(const std::vector<ErrorSoFar>& errors) override { listener_.errors(errors); }
    [[nodiscard]] bool frame_is_due(const State& state) const override { return files_->frame_is_due(state); }
    void frame(const State& state, const std::optional<double>& angle) override { files_->write_frame(state, angle); }
    void step_done(Index step) override { listener_.step_done(step); }
    [[nodiscard]] bool checkpoint_is_due(Index step, bool last_of_stage) override;
    void checkpoint(const State& state, const LoopPosition& position,
                    const std::function<void(Archive&)>& archive) override;

  private:
    const RunPlan& plan_;
    RunListener& listener_;
    const RunControl& control_;
    RunCheckpoints checkpoints_;
    std::optional<RunDirectory> files_;  ///< opened when it is known that the run can begin
};

}  // namespace ljmd
