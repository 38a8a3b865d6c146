#pragma once

#include <optional>

#include "ljmd/engine/run_measurement.hpp"
#include "ljmd/engine/run_outputs.hpp"
#include "ljmd/run/run.hpp"
#include "ljmd/run/run_checkpoints.hpp"
#include "ljmd/run/run_directory.hpp"

namespace ljmd {

/// The outputs of a run with a directory: its files, its checkpoints, and the listener.
class DirectoryOutputs : public RunOutputs {
  public:
    DirectoryOutputs(const Deck& deck, RunListener& listener, const RunControl& control);

    /// Bring a run back to the checkpoint that it is resumed from, if it is, and open the files. Nothing was changed if
    /// this throws before the files are opened.
    /// @param system  a FluidSystem or FewBodySystem, which the measurement measures
    /// @return the position to resume the time loop from  @throws CheckpointError, FileError
    template <class System>
    [[nodiscard]] std::optional<LoopPosition> begin(RunMeasurement& measurement, System& system) {
        restore(measurement, system.state);
        files_.emplace(deck_, system, control_.continuation);
        return control_.continuation ? std::optional(control_.continuation->head.position) : std::nullopt;
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
    void restore(RunMeasurement& measurement, const State& state);

    const Deck& deck_;
    RunListener& listener_;
    const RunControl& control_;
    RunCheckpoints checkpoints_;
    std::optional<RunDirectory> files_;  ///< opened when it is known that the run can begin
};

}  // namespace ljmd
